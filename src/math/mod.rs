//! Vectors, matrices and angles.
