package robotran.programs

import robotran.java.JavaCompiler
import robotran.java.loadJavaCompiler
import robotran.robolang.Calibration

/**
 * Makes what a brick can run of what a pupil has written, in either language. The compiler for Java is loaded when it is first needed, which takes
 * a while in a browser.
 *
 * @param calibration the figures of the robot that Robolang programs run on.
 * @param java how Java programs are to run.
 */
class ProgramReader(
    calibration: Calibration,
    java: JavaSettings = JavaSettings(),
) {
    private val robolang = RobolangReader(calibration)
    private val classFiles = ClassFileReader(java)
    private var compiler: JavaCompiler? = null

    /** Whether [source] can be read without loading anything. */
    fun isReadyFor(source: ProgramSource): Boolean = source !is ProgramSource.Java || compiler != null

    /**
     * Reads [source], whatever it holds. Not to be called again before it has answered.
     *
     * @throws Exception if the compiler for Java is needed and cannot be loaded, as when a browser is offline before it was ever fetched; what is thrown
     * differs from platform to platform.
     */
    suspend fun read(source: ProgramSource): ProgramResult = when (source) {
        is ProgramSource.Robolang -> robolang.read(source)
        is ProgramSource.Java -> JavaReader(loadedCompiler(), classFiles).read(source)
        is ProgramSource.ClassFiles -> classFiles.read(source)
    }

    private suspend fun loadedCompiler(): JavaCompiler = compiler ?: loadJavaCompiler().also { compiler = it }
}
