package robotran.benchmarks

import robotran.javacompiler.CompilationResult
import robotran.javacompiler.JavaCompiler
import robotran.javacompiler.loadJavaCompiler
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.languagesupport.SourceFile
import robotran.lejoslibrary.LejosLibrary
import kotlin.time.Duration
import kotlin.time.DurationUnit
import kotlin.time.TimeSource

/** The compile time of a Java program. The note contains the first times, which include loading and warm-up. */
internal suspend fun compileTime(): Measurement {
    val library = LejosLibrary.classNames.associateWith { checkNotNull(LejosLibrary.classFile(it)) }
    val begun = TimeSource.Monotonic.markNow()
    val compiler = loadJavaCompiler(messages = JavaMessages.of(Language.ENGLISH))
    val loaded = begun.elapsedNow()
    compile(compiler, javaPrograms.entries.first(), library)
    val first = begun.elapsedNow()
    val all = median { javaPrograms.forEach { compile(compiler, it, library) } }
    val note =
        "one of ${javaPrograms.size} examples; loading took ${milliseconds(loaded)}, with the first program " +
            "${milliseconds(first)}"
    return Measurement(all.toDouble(DurationUnit.MILLISECONDS) / javaPrograms.size, "ms", note)
}

private fun compile(compiler: JavaCompiler, program: Map.Entry<String, String>, library: Map<String, ByteArray>) {
    val result = compiler.compile(listOf(SourceFile(program.key, program.value)), library)
    check(result is CompilationResult.Success) { "${program.key} does not compile." }
}

private fun milliseconds(time: Duration): String = "${rounded(time.toDouble(DurationUnit.MILLISECONDS))} ms"
