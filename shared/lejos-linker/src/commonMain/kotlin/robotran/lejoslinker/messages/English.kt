package robotran.lejoslinker.messages

import robotran.lejoslinker.image.PartKind
import robotran.tinyvm.messages.EnglishTinyVmMessages

object EnglishImageMessages : ImageMessages {
    override val tinyVm get() = EnglishTinyVmMessages
    override val listing: ListingMessages get() = EnglishListingMessages

    override fun tooManyClasses(count: Int, limit: Int) =
        "This program needs $count classes, those of leJOS included. A brick takes at most $limit: use fewer."

    override fun tooManyPrograms(count: Int, limit: Int) =
        "These are $count programs. A brick takes at most $limit at once: leave some out."

    override fun tooManyConstants(count: Int, limit: Int) =
        "This program has $count different texts and large numbers, those of leJOS included. A brick reaches only " +
            "the first $limit: use fewer texts. Whole numbers from -32768 to 32767 do not count."

    override fun tooManyStaticFields(count: Int, limit: Int) =
        "This program has $count static fields, those of leJOS included. A brick reaches only the first $limit: use " +
            "fewer, or keep values in an array."

    override fun tooManyStaticBytes(count: Int, limit: Int) =
        "The static fields of this program take $count bytes. A brick reaches only $limit: use fewer, or keep values " +
            "in an array."

    override fun tooManySignatures(count: Int, limit: Int) =
        "This program has $count methods that differ in name or parameters. A brick takes at most $limit: use fewer."

    override fun objectTooLarge(bytes: Int, limit: Int) =
        "The fields of this class take $bytes bytes. A brick reaches only $limit: use fewer, or keep values in an array."

    override fun imageTooLarge(bytes: Int, limit: Int) =
        "This program takes $bytes bytes on the brick, but there is room for $limit. Use fewer classes of leJOS, or " +
            "write less code."

    override fun littleMemory(bytes: Int) =
        "On the brick, this program leaves only $bytes bytes for objects, arrays and texts. It may run out of " +
            "memory: write less code, or make fewer of them."

    override fun largeStep(variable: String, step: Int) =
        "The brick adds only numbers from -128 to 127 this way. Write \"${longForm(variable, step)}\"."

    override fun arraysOfObjectArrays() =
        "The brick cannot create arrays of objects inside an array all at once. Create the outer array first, as in " +
            "\"new String[2][]\", and then each inner array in a loop."

    override fun strangeCharacter(character: String) =
        "The brick does not know the character \"$character\". Use only plain letters, digits and signs in texts."
}

private object EnglishListingMessages : ListingMessages {
    override fun parts(bytes: Int) = "An image of $bytes bytes:"

    override fun partName(kind: PartKind) = when (kind) {
        PartKind.MASTER_RECORD -> "head"
        PartKind.CLASS_RECORDS -> "class records"
        PartKind.STATIC_STATE -> "static state"
        PartKind.STATIC_FIELD_RECORDS -> "static field records"
        PartKind.CONSTANT_RECORDS -> "constant records"
        PartKind.METHOD_RECORDS -> "method records"
        PartKind.EXCEPTION_RECORDS -> "exception records"
        PartKind.FIELD_TYPES -> "field types"
        PartKind.CODE -> "code"
        PartKind.CONSTANT_VALUES -> "constants"
        PartKind.ENTRY_CLASSES -> "programs"
    }

    override fun bytesAt(bytes: Int, offset: Int) = "$bytes ${if (bytes == 1) "byte" else "bytes"} at $offset"

    override fun objectBytes(bytes: Int) = "objects of $bytes bytes"

    override fun entryClasses() = "Programs:"

    override fun classes() = "Classes and their methods:"

    override fun constants() = "Constants:"

    override fun staticFields() = "Static fields:"

    override fun signatures() = "Signatures:"
}
