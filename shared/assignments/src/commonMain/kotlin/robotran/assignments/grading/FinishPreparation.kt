package robotran.assignments.grading

/**
 * Runs a compiled hand-in to its end at once.
 *
 * @param onProgress is called again and again, several times a second as a rule, with the number of runs that are over.
 * What it throws ends grading.
 */
fun Preparation.finish(onProgress: (runs: Int) -> Unit): GradedHandIn = when (this) {
    is Preparation.Ready -> graded(finish(runs(), onProgress))
    is Preparation.HasErrors -> GradedHandIn.HasErrors(submission, reasons)
    is Preparation.Failed -> GradedHandIn.Failed(submission, reasons)
}

private fun finish(runs: List<PreparedRun>, onProgress: (Int) -> Unit): List<RunResult> {
    val results = mutableListOf<RunResult>()
    try {
        for (run in runs) {
            var result: RunResult? = null
            while (result == null) {
                onProgress(results.size)
                result = run.advance(MILLISECONDS)
            }
            results += result
        }
    } finally {
        runs.forEach(PreparedRun::close)
    }
    return results
}

/** Virtual time: a tenth of a second of real time in a browser, as a rule. */
private const val MILLISECONDS = 20_000
