//! What is known on paper.
