package robotran.robolang.translate

import robotran.language.Language
import robotran.robolang.RobolangNxtProgram
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangRcxProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.rcxProgram
import robotran.robolang.robotFor
import robotran.robolang.testNxt
import robotran.robolang.testPrograms
import robotran.robolang.testTarget

/** All valid programs of the tests, the examples and the documents, by path. */
internal val translatablePrograms: Map<String, RobolangRcxProgram> by lazy {
    (testPrograms + documentedPrograms + examplePrograms).mapNotNull { (path, text) ->
        (
            compileRobolang(
                path,
                text,
                testTarget,
                messages = RobolangMessages.of(Language.ENGLISH),
            ) as? RobolangResult.Success
        )?.let {
            path to
                it.rcxProgram
        }
    }.toMap()
}

/** The same for a robot with an NXT, with those that only it can run. */
internal val nxtPrograms: Map<String, RobolangNxtProgram> by lazy {
    (testPrograms + documentedPrograms + examplePrograms).mapNotNull { (path, text) ->
        val result = compileRobolang(
            path,
            text,
            testNxt,
            messages = RobolangMessages.of(Language.ENGLISH),
        ) as? RobolangResult.Success
        result?.let { path to it.program as RobolangNxtProgram }
    }.toMap()
}

/** All of them, for each brick. */
internal val programsForBoth: Map<String, RobolangProgram> by lazy {
    translatablePrograms + nxtPrograms.mapKeys { "${it.key} on an NXT" }
}

/** Translates [source], named [name], to Java. */
internal fun translationOf(source: String, name: String = "test.robo"): Translation = when (
    val result = compileRobolang(
        name,
        source,
        robotFor(source),
        messages = RobolangMessages.of(Language.ENGLISH),
    )
) {
    is RobolangResult.Success -> translateRobolang(result.program)
    is RobolangResult.Failure -> throw AssertionError(result.diagnostics.joinToString("\n") { it.message })
}

/** The lines of the translation of [source], without indentation. */
internal fun javaLinesOf(source: String): List<String> = translationOf(source).java.lines().map { it.trim() }
