package robotran.nxjlibrary

import java.util.BitSet
import java.util.Enumeration
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals

/** The library's collections do the same as the JVM's when the same random things are done with them. */
class CollectionsOnJvmTest {
    private val random = Random(28)

    private fun value(): Any? = if (random.nextInt(8) == 0) null else random.nextInt(12)

    /** What [action] returns, or the kind of exception that it throws. */
    private fun outcome(action: () -> Any?): Any? = try {
        action()
    } catch (exception: RuntimeException) {
        if (exception is IndexOutOfBoundsException) "index" else exception::class.simpleName
    }

    private fun <T> both(ours: T, theirs: T, what: String, action: (T) -> Any?) =
        assertEquals(outcome { action(theirs) }, outcome { action(ours) }, what)

    @Test
    fun `lists are like those of Java`() {
        val makers = mapOf<String, () -> MutableList<Any?>>(
            "java.util.ArrayList" to { java.util.ArrayList() },
            "java.util.LinkedList" to { java.util.LinkedList() },
        )
        for ((name, make) in makers) {
            repeat(40) {
                val theirs = make()
                val ours = LibraryOnJvm.make<MutableList<Any?>>(name)
                repeat(200) { step -> changeList(ours, theirs, "$name, step $step") }
            }
        }
    }

    private fun changeList(ours: MutableList<Any?>, theirs: MutableList<Any?>, what: String) {
        val at = random.nextInt(-1, theirs.size + 2)
        val value = value()
        when (random.nextInt(16)) {
            0, 1, 2 -> both(ours, theirs, "$what add") { it.add(value) }
            3 -> both(ours, theirs, "$what add at $at") { it.add(at, value) }
            4 -> both(ours, theirs, "$what remove at $at") { it.removeAt(at) }
            5 -> both(ours, theirs, "$what remove $value") { it.remove(value) }
            6 -> both(ours, theirs, "$what set $at") { it.set(at, value) }
            7 -> both(ours, theirs, "$what get $at") { it[at] }
            8 -> both(ours, theirs, "$what indexOf") { it.indexOf(value) to it.lastIndexOf(value) }
            9 -> both(ours, theirs, "$what contains") { it.contains(value) }
            10 -> listOf(value(), value()).let { more -> both(ours, theirs, "$what addAll") { it.addAll(more) } }
            11 -> if (random.nextInt(10) == 0) both(ours, theirs, "$what clear") { it.clear() }
            12 -> both(ours, theirs, "$what iterator") { removeSome(it.iterator()) }
            13 -> both(ours, theirs, "$what listIterator") { list -> walk(list.listIterator()) }
            14 -> both(ours, theirs, "$what toArray") { list -> (list as java.util.Collection<*>).toArray().toList() }
            else -> both(ours, theirs, "$what hashCode") { it.hashCode() to (it == theirs) }
        }
        assertEquals(theirs.size, ours.size, what)
        assertEquals(theirs.toString(), ours.toString(), what)
    }

    private fun removeSome(iterator: MutableIterator<Any?>): List<Any?> = buildList {
        while (iterator.hasNext()) {
            val next = iterator.next()
            add(next)
            if (next == 3) iterator.remove()
        }
    }

    private fun walk(iterator: MutableListIterator<Any?>): List<Any?> = buildList {
        while (iterator.hasNext()) {
            add(iterator.nextIndex())
            val next = iterator.next()
            if (next == 5) iterator.set(6)
            if (next == 7) iterator.add(8)
            if (next == 9) iterator.remove()
        }
        while (iterator.hasPrevious()) add(iterator.previous())
    }

    @Test
    fun `maps are like those of Java as far as a brick has them`() {
        repeat(80) {
            val theirs = java.util.HashMap<Any?, Any?>()
            val ours = LibraryOnJvm.make<MutableMap<Any?, Any?>>("java.util.HashMap")
            repeat(300) { step -> changeMap(ours, theirs, "step $step") }
        }
    }

    private fun changeMap(ours: MutableMap<Any?, Any?>, theirs: MutableMap<Any?, Any?>, what: String) {
        val key = random.nextInt(100)
        val value = value()
        when (random.nextInt(9)) {
            0, 1, 2, 3 -> both(ours, theirs, "$what put $key") { it.put(key, value) }
            4, 5 -> both(ours, theirs, "$what remove $key") { it.remove(key) }
            6 -> both(ours, theirs, "$what get $key") { it[key] }
            7 -> both(ours, theirs, "$what containsKey $key") { it.containsKey(key) }
            else -> if (random.nextInt(10) == 0) both(ours, theirs, "$what clear") { it.clear() }
        }
        assertEquals(theirs.size, ours.size, what)
    }

    @Test
    fun `sets are like those of Java as far as a brick has them`() {
        repeat(60) {
            val theirs = java.util.HashSet<Any?>()
            val ours = LibraryOnJvm.make<MutableSet<Any?>>("java.util.HashSet")
            repeat(200) { step ->
                val value = random.nextInt(40)
                val what = "step $step"
                when (random.nextInt(5)) {
                    0, 1, 2 -> both(ours, theirs, "$what add") { it.add(value) }
                    3 -> both(ours, theirs, "$what remove") { it.remove(value) }
                    else -> both(ours, theirs, "$what contains") { it.contains(value) }
                }
                assertEquals(theirs.size, ours.size, what)
            }
        }
    }

    @Test
    fun `sets of bits are like those of Java`() {
        repeat(50) {
            val theirs = BitSet()
            val ours = LibraryOnJvm.make<Any>("java.util.BitSet")

            fun call(name: String, vararg arguments: Any) = ours.javaClass.methods.first { method ->
                method.name == name && method.parameterTypes.size == arguments.size &&
                    method.parameterTypes.all { it == Int::class.java }
            }.invoke(ours, *arguments)
            repeat(60) {
                val bit = random.nextInt(200)
                if (random.nextInt(3) > 0) {
                    theirs.set(bit)
                    call("set", bit)
                } else {
                    theirs.clear(bit)
                    call("clear", bit)
                }
                assertEquals(theirs.get(bit), call("get", bit))
                assertEquals(theirs.toString(), ours.toString())
            }
        }
    }

    @Test
    fun `texts with one sign between their words are taken apart as in Java`() {
        for (text in listOf("a", "a b c", "1,2,3", "a\tb\nc d", "x;y,z")) {
            for (separator in listOf(" ", ",", ";")) {
                val theirs = java.util.StringTokenizer(text, separator)
                val ours = LibraryOnJvm.make<Enumeration<Any?>>("java.util.StringTokenizer", text, separator)
                assertEquals(theirs.asSequence().toList(), ours.asSequence().toList(), "$text by $separator")
            }
        }
    }

    @Test
    fun `arrays are sorted as in Java`() {
        val ours = LibraryOnJvm.type("java.util.Arrays")
        repeat(200) {
            val numbers = IntArray(random.nextInt(40)) { random.nextInt(-20, 20) }
            val decimals = DoubleArray(random.nextInt(40)) {
                if (random.nextInt(6) == 0) listOf(0.0, -0.0, Double.NaN).random(random) else random.nextDouble()
            }
            assertEquals(numbers.sorted(), numbers.copyOf().also { ours.call("sort", it) }.toList())
            assertEquals(decimals.sorted(), decimals.copyOf().also { ours.call("sort", it) }.toList())
        }
    }
}
