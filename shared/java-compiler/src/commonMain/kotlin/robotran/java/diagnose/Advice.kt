package robotran.java.diagnose

import robotran.java.JavaFix

/**
 * What to tell about a problem.
 *
 * @property atEnd whether something is missing behind the place the problem is at.
 */
internal class Advice(
    val message: String,
    val hint: String? = null,
    val fix: JavaFix? = null,
    val atEnd: Boolean = false,
)
