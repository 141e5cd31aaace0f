package robotran.benchmarks

/** All benchmarks by name. */
internal val BENCHMARKS: Map<String, suspend () -> Measurement> =
    mapOf(
        "reading" to ::readingSpeed,
        "mistakes" to ::mistakesTime,
        "blocks" to ::blocksTime,
        "block-edit" to ::blockEditTime,
        "compile" to ::compileTime,
        "statements" to ::statementSpeed,
        "bytecodes" to ::bytecodeSpeed,
        "busy-loops" to ::busyLoops,
        "line-follower" to ::lineFollowerSpeed,
        "nqc-commands" to ::firmwareCommandSpeed,
        "nqc-line-follower" to ::nqcLineFollowerSpeed,
        "nxj-bytecodes" to ::nxjBytecodeSpeed,
        "nxj-doubles" to ::nxjDoubleSpeed,
        "nxj-objects" to ::nxjObjectSpeed,
        "nxj-line-follower" to ::nxjLineFollowerSpeed,
        "open-sheet" to ::openSheetSpeed,
        "walls" to ::wallsSpeed,
        "heavy" to ::heavyWorldSpeed,
        "tick" to ::tickAgainstStep,
        "heavy-tick" to ::heavyTickAgainstStep,
        "barriers" to ::growthWithBarriers,
        "robots" to ::growthWithRobots,
    )

/** Runs the benchmark [name] and returns its result in one line that starts with the name. */
internal suspend fun measured(name: String): String = "$name: ${BENCHMARKS.getValue(name)().text}"
