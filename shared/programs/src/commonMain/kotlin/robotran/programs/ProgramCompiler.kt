package robotran.programs

import robotran.javacompiler.JavaCompiler
import robotran.javacompiler.loadJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.Calibration
import robotran.tinyvm.messages.TinyVmMessages
import kotlin.coroutines.cancellation.CancellationException

/**
 * Makes what a brick can run of what a pupil has written, in either language. The compiler for Java is loaded when it
 * is first needed, which takes a while in a browser.
 *
 * @param calibration the figures of the robot that Robolang programs run on.
 * @param java how Java programs are to run.
 * @property language what mistakes are told in, and what programs tell while they run.
 */
class ProgramCompiler(
    private val calibration: Calibration,
    private val java: JavaSettings = JavaSettings(),
    val language: Language = Language.ENGLISH,
) {
    private val robolang = RobolangReader(calibration, RobolangMessages.of(language))
    private val classFiles = ClassFileReader(java, TinyVmMessages.of(language))
    private var compiler: JavaCompiler? = null

    /** A reader like this that tells everything in [language], with the compiler for Java if this one has loaded it. */
    fun withLanguage(language: Language): ProgramCompiler = ProgramCompiler(calibration, java, language).also {
        it.compiler = compiler?.withLanguage(JavaMessages.of(language))
    }

    /** A reader like this that runs Java as [java] says; itself if it does already. */
    fun withJava(java: JavaSettings): ProgramCompiler =
        if (java == this.java) this else ProgramCompiler(calibration, java, language).also { it.compiler = compiler }

    /** Loads what compiling [source] takes. */
    suspend fun prepareFor(source: ProgramSource): CompilerLoading {
        if (source !is ProgramSource.Java || compiler != null) return CompilerLoading.Loaded
        return try {
            compiler = loadJavaCompiler(JavaMessages.of(language))
            CompilerLoading.Loaded
        } catch (cancelled: CancellationException) {
            throw cancelled
        } catch (cause: Throwable) {
            // What is thrown differs from platform to platform.
            CompilerLoading.Failed(cause)
        }
    }

    /** Reads [source], whatever it holds, which it must be ready for. Not to be used from two threads at once. */
    fun compileNow(source: ProgramSource): ProgramResult = when (source) {
        is ProgramSource.Robolang -> robolang.read(source)

        is ProgramSource.Java -> JavaReader(
            checkNotNull(compiler) {
                "The compiler for Java is not loaded."
            },
            classFiles,
        ).read(source)

        is ProgramSource.CompiledClasses -> classFiles.read(source)
    }

    /**
     * Both in one: see [prepareFor] and [compileNow].
     *
     * @throws Throwable the cause of [CompilerLoading.Failed].
     */
    suspend fun read(source: ProgramSource): ProgramResult = when (val loading = prepareFor(source)) {
        CompilerLoading.Loaded -> compileNow(source)
        is CompilerLoading.Failed -> throw loading.cause
    }
}
