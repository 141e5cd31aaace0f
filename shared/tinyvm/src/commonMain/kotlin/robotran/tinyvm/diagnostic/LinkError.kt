package robotran.tinyvm.diagnostic

/**
 * Why a class cannot be put on the brick.
 *
 * @property message one or two sentences in a learner's words.
 * @property className the class with dots, such as `josx.platform.rcx.Motor`; empty if the file does not even tell its
 * class.
 * @property methodName null if it is not about one method.
 * @property sourceLine from 1; 0 if there is none.
 * @property sourceFile the file that the class stands in; null if the program has only one.
 */
data class LinkError(
    val message: String,
    val className: String,
    val methodName: String? = null,
    val sourceLine: Int = 0,
    val sourceFile: String? = null,
)

/** Ends reading or linking from deep inside; caught where the result is made. */
internal class LinkException(val refusal: LinkError) : RuntimeException(refusal.message)
