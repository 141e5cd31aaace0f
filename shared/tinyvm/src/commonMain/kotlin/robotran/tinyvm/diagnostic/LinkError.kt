package robotran.tinyvm.diagnostic

/**
 * Why a class cannot run on the brick.
 *
 * @property message one or two sentences for a learner.
 * @property className the class name with dots, such as `josx.platform.rcx.Motor`; empty if it is unknown.
 * @property methodName null if the error is not about one method.
 * @property sourceLine from 1; 0 if unknown.
 * @property sourceFile the source file of the class; null if the program has only one.
 */
data class LinkError(
    val message: String,
    val className: String,
    val methodName: String? = null,
    val sourceLine: Int = 0,
    val sourceFile: String? = null,
)

/** Aborts reading or linking; caught in `linkTinyVm`. */
internal class LinkException(val refusal: LinkError) : RuntimeException(refusal.message)
