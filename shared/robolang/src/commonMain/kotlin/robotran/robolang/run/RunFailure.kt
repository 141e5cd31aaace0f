package robotran.robolang.run

/** Thrown by an instruction that fails. [RobolangRun] catches it and reports it in its status. */
internal class RunFailure(override val message: String) : RuntimeException(message)

internal fun fail(message: String): Nothing = throw RunFailure(message)
