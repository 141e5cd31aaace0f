package robotran.programs

import robotran.brick.kind.JavaPlatform
import robotran.javacompiler.CompilerNotLoadedException
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.lejoslinker.messages.ImageMessages
import robotran.programs.messages.ProgramMessages
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
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
    ) : this(target, java, firmware, language, LoadedJava())

    private val robolang = RobolangProgramCompiler(target, RobolangMessages.of(language))
    private val classFiles = linkerFor(java)
    private val firmwarePrograms = FirmwareProgramCompiler(firmware, language)
    private val fixes = FixVerification { compileUnverified(it) }
    private val otherBrick = OtherBrick(target.kind, ProgramMessages.of(language))

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
        if (otherBrick.mistakeIn(source) == null) {
            if (source is ProgramSource.Java) loaded.loadCompiler()
            if (source !is ProgramSource.Robolang) loadLibrary()
        }
    }

    private suspend fun attempt(load: suspend () -> Unit): CompilerLoading = try {
        load()
        CompilerLoading.Loaded
    } catch (cancelled: CancellationException) {
        throw cancelled
    } catch (cause: Throwable) {
        // The exception's type depends on the platform.
        CompilerLoading.Failed(cause)
    }

    /**
     * Compiles any [source], after [prepareFor] has loaded what that needs. Not thread-safe.
     *
     * The fixes of its mistakes are known to help; only those of Java, which takes too long, are not tried out.
     */
    fun compileNow(source: ProgramSource): ProgramResult {
        otherBrick.mistakeIn(source)?.let { return ProgramResult.HasErrors(listOf(it)) }
        val result = compileUnverified(source)
        return if (source is ProgramSource.Java) result else fixes.verified(source, result)
    }

    private fun compileUnverified(source: ProgramSource): ProgramResult = when (source) {
        is ProgramSource.Robolang -> robolang.read(source)
        is ProgramSource.Java -> javaCompiler().read(source)
        is ProgramSource.ForLegoFirmware -> firmwarePrograms.read(source)

        is ProgramSource.CompiledClasses -> when (platform) {
            JavaPlatform.LEJOS -> classFiles.read(source, CompiledGaps(java, JavaMessages.of(language)))
            JavaPlatform.NXJ -> nxjLinker().read(source, java.mode, JavaMessages.of(language))
        }
    }

    /**
     * Compiles any [source] for somebody who waits, and loads what that needs. The compiler for Java works beside the
     * caller where it can; a program with which it is not ready after some time has a mistake that says so.
     */
    suspend fun compile(source: ProgramSource): TimedCompilation {
        val isForThis = otherBrick.mistakeIn(source) == null
        val loading = if (source is ProgramSource.Java && isForThis) attempt { loadLibrary() } else prepareFor(source)
        return when {
            loading is CompilerLoading.Failed -> TimedCompilation.NotLoaded(loading.cause)
            source is ProgramSource.Java && isForThis -> compileTimed(source)
            else -> TimedCompilation.Compiled(compileNow(source))
        }
    }

    private suspend fun compileTimed(source: ProgramSource.Java): TimedCompilation = try {
        val (linker, library) = javaParts()
        TimedCompilation.Compiled(timedCompiler(linker, library).read(source))
    } catch (missing: CompilerNotLoadedException) {
        TimedCompilation.NotLoaded(missing)
    }

    private suspend fun loadLibrary() {
        if (target.kind.java == JavaPlatform.NXJ) loaded.loadNxj()
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
        val others = sources.mapNotNull { otherBrick.mistakeInImage(it) }
        if (others.isNotEmpty()) return ImageBuildResult.HasErrors(others)
        val settings = JavaSettings(TinyVmMode.BRICK, version = version)
        val linker = linkerFor(settings)
        val java = timedCompiler(linker, JavaLibrary.ofLejos(settings))
        val translated = TranslatedProgramCompiler(java, ProgramMessages.of(language))
        val messages = TinyVmMessages.of(language)
        return try {
            ImageBuilder(target, RobolangMessages.of(language), java, translated, linker, messages).build(sources)
        } catch (missing: CompilerNotLoadedException) {
            ImageBuildResult.NotLoaded(missing)
        }
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

    /**
     * Compiles the Java that [source] becomes for the robot, like [compile]. Mistakes are told at the lines of [source].
     *
     * @throws Throwable if a compiler cannot be loaded, see [CompilerLoading.Failed].
     */
    suspend fun readTranslation(source: ProgramSource.Robolang): ProgramResult =
        when (val result = compileRobolang(source.name, source.text, target, RobolangMessages.of(language))) {
            is RobolangResult.HasErrors -> ProgramResult.HasErrors(result.diagnostics)

            is RobolangResult.Ready -> {
                loadLibrary()
                val (linker, library) = javaParts()
                TranslatedProgramCompiler(timedCompiler(linker, library), ProgramMessages.of(language))
                    .read(source.name, result.program, result.warnings)
            }
        }

    private fun timedCompiler(linker: ProgramLinker, library: JavaLibrary) =
        TimedJavaProgramCompiler(loaded, linker, library, language)

    private fun javaCompiler(): JavaProgramCompiler {
        val compiler = checkNotNull(loaded.compiler) { "The compiler for Java is not loaded." }
            .withLanguage(JavaMessages.of(language))
        val (linker, library) = javaParts()
        return JavaProgramCompiler(compiler, linker, library)
    }

    private fun javaParts(): Pair<ProgramLinker, JavaLibrary> = when (platform) {
        JavaPlatform.LEJOS -> classFiles to JavaLibrary.ofLejos(java)
        JavaPlatform.NXJ -> nxjLinker() to JavaLibrary.ofNxj(nxjLibrary(), java)
    }

    private val platform get() = checkNotNull(target.kind.java) { "No Java runs on ${target.kind.name}." }

    private fun nxjLinker() = NxjLinker(nxjLibrary(), java, TinyVmMessages.of(language))

    private fun nxjLibrary() = checkNotNull(loaded.nxj) { "The classes of leJOS NXJ are not loaded." }

    private fun linkerFor(settings: JavaSettings) =
        ClassFileLinker(settings, TinyVmMessages.of(language), ImageMessages.of(language))
}
