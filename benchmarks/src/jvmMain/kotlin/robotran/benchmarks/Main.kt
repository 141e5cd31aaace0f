package robotran.benchmarks

import kotlinx.coroutines.runBlocking
import kotlin.system.exitProcess

/** Measures what is named, or everything, and prints a line for each. */
fun main(vararg names: String) {
    val unknown = names.filter { it !in BENCHMARKS }
    if (unknown.isNotEmpty()) {
        System.err.println("There is no benchmark ${unknown.joinToString()}, only ${BENCHMARKS.keys.joinToString()}.")
        exitProcess(2)
    }
    for (name in BENCHMARKS.keys) {
        if (names.isEmpty() || name in names) println(runBlocking { measured(name) })
    }
}
