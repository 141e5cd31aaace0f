package robotran.benchmarks

import kotlinx.coroutines.runBlocking
import kotlin.system.exitProcess

/** Measures what is named, or everything, and prints a line for each; `fuzz` with a number of texts and a seed is a program of its own. */
fun main(vararg names: String) {
    if (names.firstOrNull() == "fuzz") return fuzz(names.drop(1))
    val known = BENCHMARKS + SCREEN_BENCHMARKS
    val unknown = names.filter { it !in known }
    if (unknown.isNotEmpty()) {
        System.err.println("There is no benchmark ${unknown.joinToString()}, only ${known.keys.joinToString()}.")
        exitProcess(2)
    }
    for ((name, measure) in known) {
        if (names.isEmpty() || name in names) println(runBlocking { measured(name, measure) })
    }
    // Drawing leaves threads behind.
    exitProcess(0)
}

/** What can be measured only where a screen can be drawn without one. */
private val SCREEN_BENCHMARKS: Map<String, suspend () -> Figure> = mapOf("keystroke" to ::keystrokeTime)
