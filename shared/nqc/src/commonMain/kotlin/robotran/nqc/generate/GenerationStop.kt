package robotran.nqc.generate

/** Leaves the task or subroutine whose code cannot be generated; the reason is already reported. */
internal class GenerationStop : Exception()
