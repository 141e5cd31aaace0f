package robotran.robolang.messages

/** What a pupil is told in English when a program cannot go on. */
internal object EnglishRunMessages : RunMessages {
    override fun divisionByZero(dividend: String) = "$dividend cannot be divided by 0."

    override fun indexOutside(index: Int, size: Int) = when (size) {
        0 -> "There is no element $index, the list is empty."
        1 -> "There is no element $index in a list of 1, only element 0."
        else -> "There is no element $index in a list of $size. They are counted from 0 to ${size - 1}."
    }

    override fun tooManyCalls(name: String, limit: Int) =
        "\"$name\" calls itself too often: a brick has no memory for more than $limit calls inside each other."

    override fun listsTooLarge(limit: Int) =
        "The brick's memory is full: all the lists made so far have more than $limit elements, and it keeps every one."

    override fun negativeTime(value: String) = "The robot cannot take $value for a time. Use 0 or more."

    override fun negativeCount(value: Int) = "Nothing can be repeated $value times. Use 0 or more."

    override fun powerOutside(value: Int) = "A motor has no power $value, only 0 to 7."

    override fun stepOfNothing() = "With steps of 0 the loop would never get on."

    override fun rootOfNegative(value: String) = "$value has no square root, because it is less than 0."

    override fun powerOfNegative(base: String, exponent: String) =
        "There is no number that is $base to the power of $exponent."

    override fun nothingReturned(name: String) = "The function \"$name\" came to its end without a \"return\"."
}
