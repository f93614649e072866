//! Every stencil test and every operation.

use microraster::{AnyCompare, AnyOperation};

pub(crate) const COMPARES: [AnyCompare; 8] = [
    AnyCompare::Never,
    AnyCompare::Less,
    AnyCompare::LessEqual,
    AnyCompare::Equal,
    AnyCompare::Greater,
    AnyCompare::GreaterEqual,
    AnyCompare::NotEqual,
    AnyCompare::Always,
];

pub(crate) const OPERATIONS: [AnyOperation; 8] = [
    AnyOperation::Keep,
    AnyOperation::Zero,
    AnyOperation::Replace,
    AnyOperation::IncrementClamp,
    AnyOperation::IncrementWrap,
    AnyOperation::DecrementClamp,
    AnyOperation::DecrementWrap,
    AnyOperation::Invert,
];
