package robotran.benchmarks

import kotlinx.coroutines.runBlocking
import kotlin.system.exitProcess

/** Measures what is named, or everything, and prints a line for each; `fuzz` with a number of texts and a seed is a program of its own. */
fun main(vararg names: String) {
    if (names.firstOrNull() == "fuzz") return fuzz(names.drop(1))
    val unknown = names.filter { it !in BENCHMARKS }
    if (unknown.isNotEmpty()) {
        System.err.println("There is no benchmark ${unknown.joinToString()}, only ${BENCHMARKS.keys.joinToString()}.")
        exitProcess(2)
    }
    for (name in BENCHMARKS.keys) {
        if (names.isEmpty() || name in names) println(runBlocking { measured(name) })
    }
}
