package robotran.legofirmware.messages

import robotran.language.quoted

internal object ImageEnglish : ImageMessages {
    override fun tooLarge(bytes: Int, limit: Int) =
        "This file has $bytes bytes. An RCX program is never larger than $limit bytes."

    override fun notAnImage() =
        "This is no RCX program file. Such a file begins with the letters RCXI and is made by an NQC compiler."

    override fun newerVersion(version: String) =
        "This file has the format version $version. Robotran reads versions up to 1.02."

    override fun otherBrick(name: String?) =
        if (name == null) "This program is for an unknown brick." else "This program is for a $name, not for an RCX."

    override fun unknownChunk(type: Int) =
        "The file has a part of an unknown kind ($type). Only tasks and subroutines are allowed."

    override fun chunkCut(chunk: String?) =
        "The file ends in the middle of ${chunk ?: "a part"}. Was it copied completely?"

    override fun numberTooHigh(isTask: Boolean, number: Int, highest: Int) =
        "There is a ${chunk(isTask, number)}, but the highest number is $highest."

    override fun chunkTwice(chunk: String) = "The file has $chunk twice."

    override fun tooManySymbols(count: Int, limit: Int) = "The file has $count names. At most $limit are allowed."

    override fun namesCut(missing: Int) = if (missing == 1) {
        "The file ends too early. One name is missing, but the program can run."
    } else {
        "The file ends too early. $missing names are missing, but the program can run."
    }

    override fun nameWithoutChunk(name: String) = "The name ${quoted(name)} belongs to nothing in this file."

    override fun extraBytes(bytes: Int) = "The file has $bytes extra bytes at its end. They are ignored."

    override fun largeProgram(bytes: Int, limit: Int) =
        "The program has $bytes bytes. A real brick has room for about $limit, for all its programs together."

    override fun noMainTask() = "The program has no task 0, so the Run button starts nothing."

    override fun chunk(isTask: Boolean, number: Int) = if (isTask) "task $number" else "subroutine $number"
}
