package robotran.robolang.run

/** Thrown by an instruction that cannot be done, and caught by [RobolangRun], which says so in its status. */
internal class RunFailure(override val message: String) : RuntimeException(message)

internal fun fail(message: String): Nothing = throw RunFailure(message)
