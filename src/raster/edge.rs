/// An edge of a triangle, or a line, walked from row to row.
pub(crate) trait Edge {
    /// The first column whose centre is not left of it in this row.
    fn column(&self) -> i32;

    /// Goes one row down.
    fn step(&mut self);
}
