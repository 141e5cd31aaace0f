package robotran.textediting.complete

/** The suffixes of the commands. */
internal val COMMAND_SUFFIXES = mapOf(
    "forward" to " |20|",
    "backward" to " |20|",
    "turn" to " ",
    "start" to " ",
    "power" to " |5|",
    "motor" to " |A| forward",
    "pen" to " ",
    "wait" to " |1| second",
    "reset" to " ",
    "play" to " |440| for 1 second",
    "show" to " ",
    "clear" to " screen",
    "repeat" to " |4| times",
    "for" to " |i| from 1 to 10",
    "if" to " ",
    "var" to " ",
    "const" to " ",
    "procedure" to " ",
    "function" to " ",
    "whenever" to " ",
    "robot" to " ",
).mapValues { CompletionSuffix.of(it.value) }

/** The suffixes of words that follow another word, by that other word. */
internal val FOLLOWER_SUFFIXES = mapOf(
    "turn" to mapOf("left" to " |90|", "right" to " |90|"),
    "wait" to mapOf("until" to " "),
    "for" to mapOf("each" to " "),
    "power" to mapOf("left" to " |5|", "right" to " |5|"),
    "reset" to mapOf("motor" to " |A|"),
    "start" to mapOf("motor" to " |A| turn 90"),
).mapValues { (_, suffixes) -> suffixes.mapValues { CompletionSuffix.of(it.value) } }

/** The suffixes of words in expressions. */
internal val VALUE_SUFFIXES = mapOf(
    "left" to " bumper",
    "right" to " bumper",
    "sensor" to " |1|",
    "button" to " ",
    "turned" to " |A|",
    "and" to " ",
    "or" to " ",
    "not" to " ",
    "mod" to " ",
).mapValues { CompletionSuffix.of(it.value) }
