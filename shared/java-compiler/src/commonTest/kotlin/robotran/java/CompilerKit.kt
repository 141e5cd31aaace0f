package robotran.java

import kotlin.test.assertIs

/** Compiles [text] as `Robot.java` together with [others] against the tiny library. */
suspend fun compile(text: String, vararg others: JavaSource): CompilationResult =
    loadJavaCompiler().compile(listOf(JavaSource("Robot.java", text)) + others, tinyLibrary())

suspend fun compiled(text: String, vararg others: JavaSource): CompilationResult.Compiled = assertIs(compile(text, *others))

suspend fun mistakes(text: String, vararg others: JavaSource): List<JavaDiagnostic> =
    assertIs<CompilationResult.Refused>(compile(text, *others)).diagnostics

/** A whole program around [statements], which begin in line 4. */
fun program(statements: String) =
    "import josx.platform.rcx.*;\npublic class Robot {\npublic static void main(String[] args) throws InterruptedException {\n$statements\n}\n}\n"
