package robotran.benchmarks

import kotlinx.coroutines.runBlocking
import kotlin.system.exitProcess

/**
 * Runs the named benchmarks, or all, and prints one line each. `fuzz` with a number of texts and a seed starts the
 * fuzzer instead.
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
