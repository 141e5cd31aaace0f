package robotran.tinyvm.messages

import robotran.tinyvm.config.Quirk

/** What is said in English while a program runs. */
internal object EnglishVmRunMessages : RunMessages {
    override fun uncaught(exception: String, text: String, methodNumber: Int, exceptionNumber: Int): String {
        val said = if (text.isEmpty()) exception else "$exception ($text)"
        return "Nobody caught the $said. A brick buzzes and shows $methodNumber and $exceptionNumber."
    }

    override fun bites(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "A brick divides only by numbers from -32768 to 32767. It drops the rest of a larger divisor."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "A brick looks only at 16 bits of an index, so a large one meets another element."
        }

        Quirk.SIGNED_CHARACTER -> {
            "On a brick, a char above 32767 becomes negative."
        }

        Quirk.UNCHECKED_INTERFACE -> {
            "On a brick, every object passes for any interface: this test or cast was not really made."
        }

        Quirk.LONG_ARRAY -> {
            "On a brick, an array has at most 511 elements."
        }

        Quirk.HEAP_FULL -> {
            "The brick's memory is full. It never gives memory back, so make objects, arrays and texts once and use " +
                "them again."
        }

        Quirk.NOT_A_NUMBER -> {
            "This decimal number is no number, and a brick takes it as equal to all others."
        }

        Quirk.JOIN_DOES_NOTHING -> {
            "On a brick, join does not wait. Ask isAlive in a loop instead."
        }
    }

    override fun sharesMemory(programBytes: Int, allBytes: Int) =
        "Of its $allBytes bytes, the program itself takes about $programBytes."

    override fun wouldBite(quirk: Quirk) = when (quirk) {
        Quirk.DIVISOR_OF_16_BITS -> {
            "A real brick would drop all but 16 bits of this divisor and get another result."
        }

        Quirk.INDEX_OF_16_BITS -> {
            "A real brick would drop all but 16 bits of this index and might meet another element."
        }

        Quirk.SIGNED_CHARACTER -> {
            "On a real brick, this char would become negative."
        }

        Quirk.UNCHECKED_INTERFACE -> {
            "A real brick would not notice that the object does not implement this interface."
        }

        Quirk.LONG_ARRAY -> {
            "A real brick has no arrays of more than 511 elements: it would throw an OutOfMemoryError."
        }

        Quirk.HEAP_FULL -> {
            "A real brick's memory would be full by now: it never gives memory back."
        }

        Quirk.NOT_A_NUMBER -> {
            "A real brick would take this as equal to all other numbers."
        }

        Quirk.JOIN_DOES_NOTHING -> {
            "On a real brick, join does not wait, so here it does not either."
        }
    }
}
