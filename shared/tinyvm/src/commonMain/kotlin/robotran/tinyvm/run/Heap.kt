package robotran.tinyvm.run

import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.NxtMemory
import robotran.tinyvm.link.ArrayType
import robotran.tinyvm.link.HeapType
import robotran.tinyvm.link.IntStack
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.link.brickBytesOf

/**
 * The memory for objects. A reference is the index of an object's first word in [words], 0 for null. An object has its
 * type id, its array length (0 if it is no array), and its fields or elements, one word each. In brick mode, memory use
 * is counted in the brick's own bytes, and no object is ever freed.
 *
 * @param types by id.
 * @param bytes brick bytes available for objects.
 */
internal class Heap(private val types: List<HeapType>, private val model: MachineModel, private val bytes: Int) {
    private val first = model.firstObject

    val words = IntArray(
        if (model.isExact) {
            first + model.heapWords
        } else if (model.heapWords == 0) {
            bytes + first
        } else {
            model.heapWords
        },
    )

    /** Whether a brick's bytes bound the memory. */
    private val isBounded = model.hasQuirks || model.isExact

    /** Bytes for something other than objects. */
    private var reserved = 0

    /** Words of living objects that the last collection found. */
    var wordsVisited = 0L
        private set
    private val objectStarts = BitSet(words.size)
    private val marked = BitSet(words.size)
    private var free = FreeBlocks(first, words.size)
    private val toVisit = IntStack()

    /** Brick bytes that the objects created so far would take. */
    var brickBytes = 0
        private set

    /** Words of all objects ever created. */
    var wordsTaken = 0L
        private set

    /** Whether the objects created so far exceed a brick's memory. */
    val isTooMuchForBrick: Boolean get() = brickBytes > bytes

    /** Free bytes as the program sees them. */
    val freeBytes: Int
        get() = if (isBounded) bytes - brickBytes else free.words * WORD_BYTES

    val totalBytes: Int
        get() = if (isBounded) bytes else words.size * WORD_BYTES

    /** Whether objects take more than [NxtMemory.NEARLY_FULL_PERCENT] of a brick's memory. */
    val isNearlyFull: Boolean get() = brickBytes > bytes / 100 * NxtMemory.NEARLY_FULL_PERCENT

    fun typeOf(reference: Int): HeapType = types[words[reference]]

    fun length(array: Int): Int = words[array + 1]

    /** Returns a new instance with all fields 0, or 0 if there is no room. */
    fun newObject(type: LinkedClass): Int = take(type, 0, type.fieldWords, type.brickBytes)

    /** Returns a new array with all elements 0, or 0 if there is no room. */
    fun newArray(type: ArrayType, length: Int): Int =
        take(type, length, length * type.elementWords, arrayBytes(type, length))

    private fun arrayBytes(type: ArrayType, length: Int): Int {
        val elementBytes = brickBytesOf(type.elementDescriptor)
        return if (model.isExact) {
            NxtMemory.arrayBytes(length, elementBytes)
        } else {
            ARRAY_HEADER_BYTES + length * elementBytes
        }
    }

    /** Reserves [wanted] brick bytes for something other than an object; returns false if there are too few. */
    fun reserve(wanted: Int): Boolean {
        if (isBounded && brickBytes + wanted > bytes) return false
        brickBytes += wanted
        reserved += wanted
        return true
    }

    /** Releases bytes that [reserve] took. */
    fun release(bytes: Int) {
        brickBytes -= bytes
        reserved -= bytes
    }

    /** Whether [word] could be a reference to an object. */
    fun isObject(word: Int): Boolean = word >= first && word < words.size && objectStarts[word]

    /**
     * Frees all objects that are not reachable from [roots], which may also pass numbers that are not references.
     * Returns false if too little memory is free to continue. Afterwards [survivedCollection] tells which objects are left.
     */
    fun collect(roots: ((Int) -> Unit) -> Unit): Boolean {
        marked.clear()
        wordsVisited = 0
        roots(::mark)
        while (!toVisit.isEmpty) visit(toVisit.pop())
        free = sweep()
        if (model.isExact) return true
        return free.words >= words.size / VirtualMachineConstants.MIN_FREED_PART
    }

    fun survivedCollection(reference: Int): Boolean = marked[reference]

    private fun take(type: HeapType, length: Int, content: Int, ownBytes: Int): Int {
        val evenBytes = rounded(ownBytes)
        if (isBounded && brickBytes + evenBytes > bytes) return 0
        val place = free.take(HEADER_WORDS + content)
        if (place == 0) return 0
        if (brickBytes <= bytes) brickBytes += evenBytes
        words.fill(0, place, place + HEADER_WORDS + content)
        words[place] = type.id
        words[place + 1] = length
        objectStarts.set(place)
        wordsTaken += HEADER_WORDS + content
        return place
    }

    private fun mark(word: Int) {
        if (!isObject(word) || marked[word]) return
        marked.set(word)
        toVisit.push(word)
    }

    private fun visit(reference: Int) {
        wordsVisited += sizeOf(reference)
        when (val type = typeOf(reference)) {
            is LinkedClass -> for (field in type.referenceWords) mark(words[reference + HEADER_WORDS + field])

            is ArrayType -> if (type.element != null) {
                for (index in 0 until length(reference)) mark(words[reference + HEADER_WORDS + index])
            }
        }
    }

    private fun sweep(): FreeBlocks {
        val blocks = FreeBlocks()
        var place = first
        var gap = place
        var bytesLeft = reserved
        while (true) {
            place = objectStarts.next(place)
            if (place < 0) break
            val size = sizeOf(place)
            if (marked[place]) {
                blocks.add(gap, place)
                gap = place + size
                if (model.isExact) bytesLeft += bytesOf(place)
            } else {
                objectStarts.remove(place)
            }
            place += size
        }
        blocks.add(gap, words.size)
        if (model.isExact) brickBytes = bytesLeft
        return blocks
    }

    /** The brick's memory rounds the bytes of an object up. */
    private fun rounded(ownBytes: Int): Int =
        if (model.isExact) (ownBytes + WORD_BYTES - 1) / WORD_BYTES * WORD_BYTES else ownBytes + (ownBytes and 1)

    private fun bytesOf(reference: Int): Int = rounded(
        when (val type = typeOf(reference)) {
            is LinkedClass -> type.brickBytes
            is ArrayType -> arrayBytes(type, length(reference))
        },
    )

    /** The words of the object [reference], with those before its content. */
    fun sizeOf(reference: Int): Int = HEADER_WORDS + when (val type = typeOf(reference)) {
        is LinkedClass -> type.fieldWords
        is ArrayType -> length(reference) * type.elementWords
    }

    companion object {
        /** Words before an object's fields or elements. */
        const val HEADER_WORDS = 2

        /** Source: leJOS `memory.h`, HEADER_SIZE. */
        const val ARRAY_HEADER_BYTES = 4

        private const val WORD_BYTES = 4
    }
}
