package robotran.javacompiler

import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.language.source.SourceFix
import robotran.languagesupport.SourceFile
import robotran.lejoslibrary.LejosLibrary
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** The class files of leJOS. It is always the same map, so that the compiler reads the classes only once. */
val library: Map<String, ByteArray> by lazy {
    LejosLibrary.classNames.associateWith { assertNotNull(LejosLibrary.classFile(it)) }
}

private var compiler: JavaCompiler? = null

/** Loads the compiler on first use and then returns the same one. */
suspend fun compiler(): JavaCompiler =
    compiler ?: loadJavaCompiler(messages = JavaMessages.of(Language.ENGLISH)).also { compiler = it }

/** Compiles [text] as `Robot.java` together with [others]. */
suspend fun compile(text: String, vararg others: SourceFile): CompilationResult =
    compiler().compile(listOf(SourceFile("Robot.java", text)) + others, library)

suspend fun compiled(text: String, vararg others: SourceFile): CompilationResult.Success =
    assertIs(compile(text, *others))

suspend fun diagnostics(text: String, vararg others: SourceFile): List<Diagnostic> =
    assertIs<CompilationResult.Failure>(compile(text, *others)).diagnostics

/** A whole program with [statements], which begin in line 4. */
fun program(statements: String) =
    "import josx.platform.rcx.*;\npublic class Robot {\npublic static void main(String[] args) throws " +
        "InterruptedException {\n$statements\n}\n}\n"

/** The first diagnostic for [statements] in a main method. */
suspend fun diagnostic(statements: String): Diagnostic = diagnostics(program(statements)).first()

/** The first diagnostic for [declarations] as class members. */
suspend fun memberDiagnostic(declarations: String): Diagnostic = diagnostics("class Robot {\n$declarations\n}").first()

/** Returns [text] with [fix] applied. */
fun withFix(text: String, fix: SourceFix): String {
    val lines = text.lines().toMutableList()
    val line = lines[fix.range.line - 1]
    lines[fix.range.line - 1] =
        line.substring(0, fix.range.column - 1) + fix.replacement + line.substring(fix.range.endColumn - 1)
    return lines.joinToString("\n")
}

/** Returns [statements] of a main method with the fix of their first diagnostic applied. */
suspend fun fixedStatements(statements: String): String {
    val text = withFix(program(statements), assertNotNull(diagnostic(statements).fix))
    return text.substringAfter("InterruptedException {\n").removeSuffix("\n}\n}\n")
}

/** Asserts that [described] ends with the sentence [advice], which says what to do instead. */
fun assertAdvice(advice: String, described: Diagnostic) =
    assertTrue(described.message.endsWith(" $advice"), described.message)
