package robotran.programs

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.lejoslinker.messages.ImageMessages
import robotran.tinyvm.messages.TinyVmMessages

/** Compiles Java and links class files for a [brick]. What it has [loaded] serves others, too. */
internal class JavaToolchain(
    private val brick: BrickKind,
    private val settings: JavaSettings,
    private val language: Language,
    private val loaded: LoadedJava,
) : LanguageCompiler {
    val classFiles = ClassFileLinker(settings, TinyVmMessages.of(language), ImageMessages.of(language))

    override val beside: CompilerBeside = object : CompilerBeside {
        override suspend fun load() = loadLibrary()

        override suspend fun compile(program: Program): ProgramResult = timed().read(program)
    }

    override suspend fun load() {
        loaded.loadCompiler()
        loadLibrary()
    }

    /** Loads the classes of the brick, if they are not at hand. */
    suspend fun loadLibrary() {
        if (brick.java == JavaPlatform.NXJ) loaded.loadNxj()
    }

    override fun compile(program: Program): ProgramResult {
        val compiler = checkNotNull(loaded.compiler) { "The compiler for Java is not loaded." }
            .withLanguage(JavaMessages.of(language))
        return JavaProgramCompiler(compiler, linker(), library()).read(program)
    }

    override suspend fun compileToClasses(program: Program, java: suspend () -> TimedJavaProgramCompiler) =
        java().compile(program)

    /** A compiler that works beside the caller, after [loadLibrary]. */
    fun timed() = TimedJavaProgramCompiler(loaded, linker(), library(), language)

    /** Links what another compiler made. */
    fun link(source: ProgramSource.CompiledClasses): ProgramResult = when (platform) {
        JavaPlatform.LEJOS -> classFiles.link(source, CompiledGaps(settings, JavaMessages.of(language)))
        JavaPlatform.NXJ -> nxjLinker().link(source, settings.mode, JavaMessages.of(language))
    }

    fun link(compiled: CompiledSource): ProgramResult = linked(compiled, linker())

    private fun linker(): ProgramLinker = when (platform) {
        JavaPlatform.LEJOS -> classFiles
        JavaPlatform.NXJ -> nxjLinker()
    }

    private fun library(): JavaLibrary = when (platform) {
        JavaPlatform.LEJOS -> JavaLibrary.ofLejos(settings)
        JavaPlatform.NXJ -> JavaLibrary.ofNxj(nxjLibrary(), settings)
    }

    private val platform get() = checkNotNull(brick.java) { "No Java runs on ${brick.name}." }

    private fun nxjLinker() = NxjLinker(nxjLibrary(), settings, TinyVmMessages.of(language))

    private fun nxjLibrary() = checkNotNull(loaded.nxj) { "The classes of leJOS NXJ are not loaded." }
}
