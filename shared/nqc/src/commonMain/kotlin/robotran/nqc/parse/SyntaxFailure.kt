package robotran.nqc.parse

/** Leaves a statement with a mistake, which is already reported. */
internal class SyntaxFailure : Exception()
