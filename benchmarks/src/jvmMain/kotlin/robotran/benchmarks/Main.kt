package robotran.benchmarks

import kotlinx.coroutines.runBlocking
import kotlin.system.exitProcess

/**
 * Measures what is named, or everything, and prints a line for each; `fuzz` with a number of texts and a seed is a
 * program of its own.
 */
fun main(vararg names: String) {
    if (names.firstOrNull() == "fuzz") return fuzz(names.drop(1))
    val all = BENCHMARKS + SCREEN_BENCHMARKS
    val unknown = names.filter { it !in all }
    if (unknown.isNotEmpty()) {
        System.err.println("There is no benchmark ${unknown.joinToString()}, only ${all.keys.joinToString()}.")
        exitProcess(2)
    }
    for ((name, measure) in all) {
        if (names.isEmpty() || name in names) println("$name: ${runBlocking { measure() }.text}")
    }
}
