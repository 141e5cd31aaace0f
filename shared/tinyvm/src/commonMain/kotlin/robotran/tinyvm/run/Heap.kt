package robotran.tinyvm.run

import robotran.tinyvm.config.TinyVmMode
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
internal class Heap(private val types: List<HeapType>, private val mode: TinyVmMode, private val bytes: Int) {
    val words = IntArray(
        if (mode == TinyVmMode.BRICK) bytes + FIRST_OBJECT else VirtualMachineConstants.FORGIVING_HEAP_WORDS,
    )
    private val objectStarts = BitSet(words.size)
    private val marked = BitSet(words.size)
    private var free = FreeBlocks(words.size)
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
        get() = if (mode == TinyVmMode.BRICK) bytes - brickBytes else free.words * WORD_BYTES

    val totalBytes: Int
        get() = if (mode == TinyVmMode.BRICK) bytes else words.size * WORD_BYTES

    fun typeOf(reference: Int): HeapType = types[words[reference]]

    fun length(array: Int): Int = words[array + 1]

    /** Returns a new instance with all fields 0, or 0 if there is no room. */
    fun newObject(type: LinkedClass): Int = take(type, 0, type.fieldWords, type.brickBytes)

    /** Returns a new array with all elements 0, or 0 if there is no room. */
    fun newArray(type: ArrayType, length: Int): Int =
        take(type, length, length, ARRAY_HEADER_BYTES + length * brickBytesOf(type.elementDescriptor))

    /** Reserves [wanted] brick bytes for something other than an object; returns false if there are too few. */
    fun reserve(wanted: Int): Boolean {
        if (mode == TinyVmMode.BRICK && brickBytes + wanted > bytes) return false
        brickBytes += wanted
        return true
    }

    /** Releases bytes that [reserve] took. */
    fun release(reserved: Int) {
        brickBytes -= reserved
    }

    /** Whether [word] could be a reference to an object. */
    fun isObject(word: Int): Boolean = word in FIRST_OBJECT until words.size && objectStarts[word]

    /**
     * Frees all objects that are not reachable from [roots], which may also pass numbers that are not references.
     * Returns false if too little memory is free to continue. Afterwards [survivedCollection] tells which objects are left.
     */
    fun collect(roots: ((Int) -> Unit) -> Unit): Boolean {
        marked.clear()
        roots(::mark)
        while (!toVisit.isEmpty) visit(toVisit.pop())
        free = sweep()
        return free.words >= words.size / VirtualMachineConstants.MIN_FREED_PART
    }

    fun survivedCollection(reference: Int): Boolean = marked[reference]

    private fun take(type: HeapType, length: Int, content: Int, ownBytes: Int): Int {
        val evenBytes = ownBytes + (ownBytes and 1)
        if (mode == TinyVmMode.BRICK && brickBytes + evenBytes > bytes) return 0
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
        when (val type = typeOf(reference)) {
            is LinkedClass -> for (field in type.referenceWords) mark(words[reference + HEADER_WORDS + field])

            is ArrayType -> if (type.element != null) {
                for (index in 0 until length(reference)) mark(words[reference + HEADER_WORDS + index])
            }
        }
    }

    private fun sweep(): FreeBlocks {
        val blocks = FreeBlocks()
        var place = FIRST_OBJECT
        var gap = place
        while (place < words.size) {
            if (!objectStarts[place]) {
                place++
                continue
            }
            val size = sizeOf(place)
            if (marked[place]) {
                blocks.add(gap, place)
                gap = place + size
            } else {
                objectStarts.remove(place)
            }
            place += size
        }
        blocks.add(gap, words.size)
        return blocks
    }

    private fun sizeOf(reference: Int): Int = HEADER_WORDS + when (val type = typeOf(reference)) {
        is LinkedClass -> type.fieldWords
        is ArrayType -> length(reference)
    }

    companion object {
        /** Words before an object's fields or elements. */
        const val HEADER_WORDS = 2

        /** The smallest reference; the words before it belong to null. */
        const val FIRST_OBJECT = 2

        /** Source: leJOS `memory.h`, HEADER_SIZE. */
        const val ARRAY_HEADER_BYTES = 4

        private const val WORD_BYTES = 4
    }
}
