package robotran.benchmarks

import kotlin.system.exitProcess

/** Measures what is named, or everything, and prints a line for each; `fuzz` with a number of texts and a seed is a program of its own. */
fun main(vararg names: String) {
    if (names.firstOrNull() == "fuzz") return fuzz(names.drop(1))
    val unknown = names.filter { it !in BENCHMARKS }
    if (unknown.isNotEmpty()) {
        System.err.println("There is no benchmark ${unknown.joinToString()}, only ${BENCHMARKS.keys.joinToString()}.")
        exitProcess(2)
    }
    for ((name, benchmark) in BENCHMARKS) {
        if (names.isEmpty() || name in names) println("$name: ${benchmark()}")
    }
}

/** Each measures something and tells the result in a line. */
private val BENCHMARKS: Map<String, () -> String> =
    mapOf(
        "session" to ::sessionSpeed,
        "reading" to ::readingSpeed,
        "mistakes" to ::mistakesTime,
        "statements" to ::statementSpeed,
    )
