package robotran.programs

import robotran.javacompiler.JavaCompiler
import robotran.javacompiler.loadJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.lejoslinker.messages.ImageMessages
import robotran.programs.messages.ProgramMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robot.Calibration
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.messages.TinyVmMessages
import kotlin.coroutines.cancellation.CancellationException

/**
 * Compiles a pupil's program, in either language, to a program for the brick. It loads the Java compiler on first use,
 * which takes a while in a browser.
 *
 * @param calibration the calibration of the robot that Robolang programs run on.
 * @param java how Java programs run.
 * @property language the language of compiler messages and runtime messages.
 */
class ProgramCompiler(
    private val calibration: Calibration,
    private val java: JavaSettings = JavaSettings(),
    val language: Language = Language.ENGLISH,
) {
    private val robolang = RobolangProgramCompiler(calibration, RobolangMessages.of(language))
    private val classFiles = linkerFor(java)
    private var compiler: JavaCompiler? = null

    /** Returns a compiler with messages in [language]. It reuses the Java compiler if it is loaded. */
    fun withLanguage(language: Language): ProgramCompiler = ProgramCompiler(calibration, java, language).also {
        it.compiler = compiler?.withLanguage(JavaMessages.of(language))
    }

    /** Returns a compiler that runs Java with the settings [java]; this one if it already does. */
    fun withJava(java: JavaSettings): ProgramCompiler =
        if (java == this.java) this else ProgramCompiler(calibration, java, language).also { it.compiler = compiler }

    /** Returns a compiler for a robot with this [calibration]; this one if it already is. */
    fun withCalibration(calibration: Calibration): ProgramCompiler = if (calibration == this.calibration) {
        this
    } else {
        ProgramCompiler(calibration, java, language).also { it.compiler = compiler }
    }

    /** Loads the compiler that [source] needs. */
    suspend fun prepareFor(source: ProgramSource): CompilerLoading {
        if (source !is ProgramSource.Java) return CompilerLoading.Loaded
        return try {
            loadedCompiler()
            CompilerLoading.Loaded
        } catch (cancelled: CancellationException) {
            throw cancelled
        } catch (cause: Throwable) {
            // The exception's type depends on the platform.
            CompilerLoading.Failed(cause)
        }
    }

    /** Compiles any [source], after [prepareFor] has loaded its compiler. Not thread-safe. */
    fun compileNow(source: ProgramSource): ProgramResult = when (source) {
        is ProgramSource.Robolang -> {
            robolang.read(source)
        }

        is ProgramSource.Java -> {
            JavaProgramCompiler(
                checkNotNull(compiler) {
                    "The compiler for Java is not loaded."
                },
                classFiles,
                java,
            ).read(source)
        }

        is ProgramSource.CompiledClasses -> {
            classFiles.read(source, CompiledGaps(java, JavaMessages.of(language)))
        }
    }

    /**
     * Builds the image of [sources] for a real brick with leJOS [version]; the Prgm button goes through them in this
     * order. Robolang programs become Java first, so they need the Java compiler, too.
     *
     * @param sources at least one program.
     * @throws Throwable whatever the platform throws if the Java compiler cannot be loaded; see [CompilerLoading.Failed].
     */
    suspend fun buildImage(sources: List<ProgramSource>, version: LejosVersion = java.version): ImageBuildResult {
        require(sources.isNotEmpty()) { "There is no program to build an image of." }
        val settings = JavaSettings(TinyVmMode.BRICK, version = version)
        val linker = linkerFor(settings)
        val loaded = if (sources.all { it is ProgramSource.CompiledClasses }) null else loadedCompiler()
        val java = loaded?.let { JavaProgramCompiler(it, linker, settings) }
        val translated = java?.let { TranslatedProgramCompiler(it, ProgramMessages.of(language)) }
        val messages = TinyVmMessages.of(language)
        return ImageBuilder(calibration, RobolangMessages.of(language), java, translated, linker, messages)
            .build(sources)
    }

    /**
     * Calls [prepareFor], then [compileNow].
     *
     * @throws Throwable the cause of [CompilerLoading.Failed].
     */
    suspend fun read(source: ProgramSource): ProgramResult = when (val loading = prepareFor(source)) {
        CompilerLoading.Loaded -> compileNow(source)
        is CompilerLoading.Failed -> throw loading.cause
    }

    private suspend fun loadedCompiler(): JavaCompiler =
        compiler ?: loadJavaCompiler(JavaMessages.of(language)).also { compiler = it }

    private fun linkerFor(settings: JavaSettings) =
        ClassFileLinker(settings, TinyVmMessages.of(language), ImageMessages.of(language))
}
