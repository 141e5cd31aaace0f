package robotran.programs

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.javacompiler.CompilerNotLoadedException
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.source.Diagnostic
import robotran.languagesupport.ParsedSource
import robotran.programs.messages.ProgramMessages
import robotran.robolang.robot.RobotTarget
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.messages.TinyVmMessages
import kotlin.coroutines.cancellation.CancellationException

/**
 * Compiles a pupil's program, in any language, to a program for the robot's brick. It loads the Java compiler and the
 * classes of leJOS NXJ on first use, which takes a while in a browser. Copies for another language, robot or settings
 * share what is loaded.
 *
 * @param target the robot that programs run on. A program for another kind of brick has a mistake.
 * @param java how Java programs run.
 * @param firmware how programs for LEGO's own firmware are compiled.
 * @param compilesBeside whether a slow compiler may work beside the caller, in a thread or worker of its own. Without it
 * all results come on the caller's thread, which tests of screens need: their dispatcher resumes on any thread.
 * @property language the language of compiler messages and runtime messages.
 */
class ProgramCompiler private constructor(
    private val target: RobotTarget,
    private val java: JavaSettings,
    private val firmware: FirmwareSettings,
    val language: Language,
    private val loaded: LoadedJava,
) {
    constructor(
        target: RobotTarget,
        java: JavaSettings = JavaSettings(),
        language: Language,
        firmware: FirmwareSettings = FirmwareSettings(),
        compilesBeside: Boolean = true,
    ) : this(target, java, firmware, language, LoadedJava(compilesBeside))

    private val javaTools = JavaToolchain(target.kind, java, language, loaded)
    private val settings = CompilerSettings(target, language, javaTools, firmware)
    private val compilers = HashMap<ProgramLanguage, LanguageCompiler>()
    private val fixes = FixVerification { compileUnverified(it) }
    private val otherBrick = OtherBrick(target.kind, ProgramMessages.of(language))

    private fun compilerOf(language: ProgramLanguage) = compilers.getOrPut(language) { language.compiler(settings) }

    /** Returns a compiler with messages in [language]. */
    fun withLanguage(language: Language): ProgramCompiler = ProgramCompiler(target, java, firmware, language, loaded)

    /** Returns a compiler that runs Java with the settings [java]; this one if it already does. */
    fun withJava(java: JavaSettings): ProgramCompiler =
        if (java == this.java) this else ProgramCompiler(target, java, firmware, language, loaded)

    /** Returns a compiler that compiles for LEGO's firmware with these settings; this one if it already does. */
    fun withFirmware(firmware: FirmwareSettings): ProgramCompiler =
        if (firmware == this.firmware) this else ProgramCompiler(target, java, firmware, language, loaded)

    /** Returns a compiler for the robot [target]; this one if it already is. */
    fun forTarget(target: RobotTarget): ProgramCompiler =
        if (target == this.target) this else ProgramCompiler(target, java, firmware, language, loaded)

    /** Loads what compiling [source] needs. */
    suspend fun prepareFor(source: ProgramSource): CompilerLoading = attempt {
        if (wrongBrick(source) == null) {
            when (source) {
                is Program -> compilerOf(source.language).load()
                is ProgramSource.CompiledClasses -> javaTools.loadLibrary()
                is ProgramSource.FirmwareImage -> Unit
            }
        }
    }

    /** The mistake that [source] is for another brick, unless its compiler tells that by itself. */
    private fun wrongBrick(source: ProgramSource): Diagnostic? =
        if (source is Program && compilerOf(source.language).tellsOtherBrick) null else otherBrick.errorIn(source)

    private suspend fun attempt(load: suspend () -> Unit): CompilerLoading = try {
        load()
        CompilerLoading.Success
    } catch (cancelled: CancellationException) {
        throw cancelled
    } catch (cause: Throwable) {
        // The exception's type depends on the platform.
        CompilerLoading.Failure(cause)
    }

    /**
     * Compiles any [source], after [prepareFor] has loaded what that needs. Not thread-safe.
     *
     * The fixes of its mistakes are known to help; only those of a slow compiler are not tried out.
     *
     * @param read its text, if an editor has read it; a language that knows it does not read it again.
     */
    fun compileNow(source: ProgramSource, read: ParsedSource? = null): ProgramResult {
        wrongBrick(source)?.let { return ProgramResult.Failure(listOf(it)) }
        val result = compileUnverified(source, read)
        return if (source.language?.support?.hasSlowCompiler == true) result else fixes.verified(source, result)
    }

    private fun compileUnverified(source: ProgramSource, read: ParsedSource? = null): ProgramResult = when (source) {
        is Program -> compilerOf(source.language).run { if (read == null) compile(source) else compile(source, read) }

        is ProgramSource.CompiledClasses -> javaTools.link(source)
        is ProgramSource.FirmwareImage -> source.compile(language)
    }

    /** Whether [source] has no mistakes, after [prepareFor] has loaded what telling that needs. */
    fun accepts(source: ProgramSource): Boolean = compileUnverified(source) is ProgramResult.Success

    /**
     * Compiles any [source] for somebody who waits, and loads what that needs. A slow compiler works beside the caller
     * where it can; a program with which it is not ready after some time has a mistake that says so.
     */
    suspend fun compile(source: ProgramSource): TimedCompilation {
        val beside = (source as? Program)?.takeIf { wrongBrick(it) == null }?.let { compilerOf(it.language).beside }
        val loading = if (beside == null) prepareFor(source) else attempt { beside.load() }
        return when {
            loading is CompilerLoading.Failure -> TimedCompilation.NotLoaded(loading.cause)
            beside == null -> TimedCompilation.Compiled(compileNow(source))
            else -> beside.compileTimed(source)
        }
    }

    private suspend fun CompilerBeside.compileTimed(program: Program): TimedCompilation = try {
        TimedCompilation.Compiled(compile(program))
    } catch (missing: CompilerNotLoadedException) {
        TimedCompilation.NotLoaded(missing)
    }

    /**
     * Builds the image of [sources] for a real RCX with leJOS [version]; the Prgm button goes through them in this
     * order. Robolang programs become Java first, so they need the Java compiler, too. A program for another brick has a
     * mistake.
     *
     * Compiles like [compile], beside the caller and within a time limit where it can.
     *
     * @param sources at least one program.
     */
    suspend fun buildImage(sources: List<ProgramSource>, version: LejosVersion = java.version): ImageBuildResult {
        require(sources.isNotEmpty()) { "There is no program to build an image of." }
        val others = sources.mapNotNull { otherBrick.errorInImage(it) }
        if (others.isNotEmpty()) return ImageBuildResult.Failure(others)
        val settings = JavaSettings(TinyVmMode.BRICK, version = version)
        val forBrick = JavaToolchain(BrickKind.with(JavaPlatform.LEJOS), settings, language, loaded)
        val messages = TinyVmMessages.of(language)
        return try {
            ImageBuilder(::compilerOf, forBrick.timed(), forBrick.classFiles, messages).build(sources)
        } catch (missing: CompilerNotLoadedException) {
            ImageBuildResult.NotLoaded(missing)
        }
    }

    /**
     * Calls [prepareFor], then [compileNow].
     *
     * @throws Throwable the cause of [CompilerLoading.Failure].
     */
    suspend fun compileOrThrow(source: ProgramSource): ProgramResult = when (val loading = prepareFor(source)) {
        CompilerLoading.Success -> compileNow(source)
        is CompilerLoading.Failure -> throw loading.cause
    }

    /**
     * Compiles the Java that [source] becomes for the robot, like [compile]. Mistakes are told at the lines of [source].
     *
     * @throws Throwable if a compiler cannot be loaded, see [CompilerLoading.Failure].
     */
    suspend fun compileTranslation(source: Program): ProgramResult = javaTools.link(
        compilerOf(source.language).compileToClasses(source) {
            javaTools.loadLibrary()
            javaTools.timed()
        },
    )
}
