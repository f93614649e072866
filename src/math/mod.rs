//! interim
#![allow(missing_docs, missing_debug_implementations)]
mod reciprocal; mod wide; pub use reciprocal::{reciprocal, Reciprocal}; pub(crate) use wide::{BY_HALVES, mul_high, mul_high_signed, wide_product};
#[derive(Clone, Copy, Debug, PartialEq)] pub struct Vec3 { pub x: f32, pub y: f32, pub z: f32 }
#[derive(Clone, Copy, Debug, PartialEq)] pub struct Vec4 { pub x: f32, pub y: f32, pub z: f32, pub w: f32 }
#[derive(Clone, Copy, Debug, PartialEq)] pub struct Angle(pub f32);
impl Vec3 { pub const ZERO: Self = Self::new(0.,0.,0.); pub const Y: Self = Self::new(0.,1.,0.); pub const fn new(x: f32, y: f32, z: f32) -> Self { Self{x,y,z} }
 pub fn dot(self, o: Self) -> f32 { self.x*o.x+self.y*o.y+self.z*o.z }
 pub fn cross(self, o: Self) -> Self { Self::new(self.y*o.z-self.z*o.y, self.z*o.x-self.x*o.z, self.x*o.y-self.y*o.x) }
 pub fn normalize(self) -> Self { let l = sqrt(self.dot(self)); if l > 0. { self * (1./l) } else { Self::ZERO } } }
pub fn sqrt(v: f32) -> f32 { let mut x = v.max(1e-20); for _ in 0..60 { x = 0.5*(x+v/x); } x }
impl core::ops::Mul<f32> for Vec3 { type Output = Self; fn mul(self, s: f32) -> Self { Self::new(self.x*s,self.y*s,self.z*s) } }
impl core::ops::Neg for Vec3 { type Output = Self; fn neg(self) -> Self { self * -1.0 } }
impl core::ops::Sub for Vec3 { type Output = Self; fn sub(self, o: Self) -> Self { Self::new(self.x-o.x,self.y-o.y,self.z-o.z) } }
#[derive(Clone, Copy, Debug, PartialEq)] pub struct Mat4(pub [[f32;4];4]);
impl Mat4 { pub const IDENTITY: Self = Self([[1.,0.,0.,0.],[0.,1.,0.,0.],[0.,0.,1.,0.],[0.,0.,0.,1.]]);
 pub fn rows(&self) -> [[f32;4];4] { self.0 }
 pub fn transpose(&self) -> Self { let mut r = *self; for i in 0..4 { for j in 0..4 { r.0[i][j] = self.0[j][i]; } } r }
 pub fn translation(v: Vec3) -> Self { let mut r = Self::IDENTITY; r.0[0][3]=v.x; r.0[1][3]=v.y; r.0[2][3]=v.z; r }
 pub fn scale(v: Vec3) -> Self { let mut r = Self::IDENTITY; r.0[0][0]=v.x; r.0[1][1]=v.y; r.0[2][2]=v.z; r }
 pub fn transform_vector(&self, v: Vec3) -> Vec3 { let m=&self.0; let d=|i:usize| m[i][0]*v.x+m[i][1]*v.y+m[i][2]*v.z; Vec3::new(d(0),d(1),d(2)) }
 pub fn look_at(eye: Vec3, target: Vec3, up: Vec3) -> Self { let f=(target-eye).normalize(); let s=f.cross(up).normalize(); let u=s.cross(f); Self([[s.x,s.y,s.z,-s.dot(eye)],[u.x,u.y,u.z,-u.dot(eye)],[-f.x,-f.y,-f.z,f.dot(eye)],[0.,0.,0.,1.]]) }
 pub fn perspective(fov: Angle, aspect: f32, near: f32, far: Option<f32>) -> Self { let t = fov.0/2.; let f = 1.0/(t + t*t*t/3. + 2.*t*t*t*t*t/15. + 17./315.*t*t*t*t*t*t*t); let (a,b) = match far { None => (0., near), Some(f) => (near/(f-near), near*f/(f-near)) }; Self([[f/aspect,0.,0.,0.],[0.,f,0.,0.],[0.,0.,a,b],[0.,0.,-1.,0.]]) }
 pub fn orthographic(l: f32, r: f32, b: f32, t: f32, n: f32, f: f32) -> Self { Self([[2./(r-l),0.,0.,-(r+l)/(r-l)],[0.,2./(t-b),0.,-(t+b)/(t-b)],[0.,0.,1./(f-n),f/(f-n)],[0.,0.,0.,1.]]) }
 pub fn rotation_y(a: Angle) -> Self { let (s,c)=sc(a.0); Self([[c,0.,s,0.],[0.,1.,0.,0.],[-s,0.,c,0.],[0.,0.,0.,1.]]) }
}
fn sc(mut a: f32) -> (f32,f32) { let p=core::f32::consts::PI; while a>p {a-=2.*p;} while a< -p {a+=2.*p;} let x=a; let mut s=0.; let mut c=0.; let mut t=1.; for i in 0..20 { if i%2==0 { c+= if i%4==0 {t} else {-t}; } else { s += if i%4==1 {t} else {-t}; } t*=x/(i as f32+1.); } (s,c) }
impl core::ops::Mul for Mat4 { type Output = Self; fn mul(self, o: Self) -> Self { let mut r=[[0.;4];4]; for i in 0..4 { for j in 0..4 { for k in 0..4 { r[i][j]+=self.0[i][k]*o.0[k][j]; } } } Self(r) } }
pub trait Degrees { fn degrees(self) -> Angle; } impl Degrees for f32 { fn degrees(self) -> Angle { Angle(self*core::f32::consts::PI/180.) } }
impl Angle { pub const fn from_degrees(d: f32) -> Self { Self(d*0.017453292) } }
impl core::ops::Add for Vec3 { type Output = Self; fn add(self, o: Self) -> Self { Self::new(self.x+o.x,self.y+o.y,self.z+o.z) } }
