package robotran.javacompiler.diagnose

import robotran.javacompiler.messages.AbsentFromBrick
import robotran.javacompiler.messages.NewerJava

/** Classes, and methods with the class before them, that programs for computers use and a brick does not have. */
private val ABSENT: Map<String, AbsentFromBrick> = buildMap {
    fun put(what: AbsentFromBrick, names: String) = names.split(' ').forEach { put(it, what) }
    put(AbsentFromBrick.PRINTING, "System.out System.err PrintStream")
    put(AbsentFromBrick.KEYBOARD, "System.in Scanner BufferedReader InputStreamReader Console")
    put(AbsentFromBrick.COLLECTIONS, "ArrayList List LinkedList Collection Collections Map HashMap TreeMap LinkedHashMap")
    put(AbsentFromBrick.COLLECTIONS, "Set HashSet TreeSet Iterator Iterable")
    put(AbsentFromBrick.COLLECTIONS, "Enumeration Arrays Deque ArrayDeque Comparable Comparator")
    put(AbsentFromBrick.RUNNABLE, "Runnable Callable ExecutorService Executors")
    put(AbsentFromBrick.FORMATTING, "String.format Formatter DecimalFormat NumberFormat")
    put(AbsentFromBrick.TEXT_METHODS, "String.substring String.indexOf String.compareTo")
    put(AbsentFromBrick.TEXT_METHODS, "String.split String.trim String.isEmpty")
    put(AbsentFromBrick.TEXT_METHODS, "String.toUpperCase String.toLowerCase")
    put(AbsentFromBrick.TEXT_METHODS, "String.equalsIgnoreCase String.replace String.contains")
    put(AbsentFromBrick.TEXT_METHODS, "String.startsWith String.endsWith String.lastIndexOf String.concat")
    put(AbsentFromBrick.TEXT_METHODS, "String.matches String.replaceAll")
    put(AbsentFromBrick.TEXT_METHODS, "String.getBytes String.compareToIgnoreCase String.intern")
    put(AbsentFromBrick.VECTOR_METHODS, "Vector.add Vector.get Vector.set Vector.remove Vector.contains")
    put(AbsentFromBrick.VECTOR_METHODS, "Vector.firstElement Vector.lastElement")
    put(AbsentFromBrick.VECTOR_METHODS, "Vector.iterator Vector.elements Vector.removeAll")
    put(AbsentFromBrick.HASHTABLE_METHODS, "Hashtable.containsKey Hashtable.contains Hashtable.containsValue")
    put(AbsentFromBrick.HASHTABLE_METHODS, "Hashtable.remove Hashtable.size Hashtable.keys")
    put(AbsentFromBrick.HASHTABLE_METHODS, "Hashtable.isEmpty Hashtable.clear Hashtable.keySet")
    put(AbsentFromBrick.WRITING_NUMBERS, "String.valueOf Integer.toHexString")
    put(AbsentFromBrick.WRITING_NUMBERS, "Integer.toBinaryString Float.toString Integer.intValue")
    put(AbsentFromBrick.SYSTEM_METHODS, "System.nanoTime System.gc System.identityHashCode System.getProperty")
    put(AbsentFromBrick.ARRAY_COPYING, "System.arraycopy")
    put(AbsentFromBrick.PARSING, "Integer.parseInt Integer.valueOf Integer.decode Float.parseFloat Double.parseDouble")
    put(AbsentFromBrick.WRAPPERS, "Boolean Byte Character Short Long Double Number BigInteger BigDecimal")
    put(AbsentFromBrick.FILES, "File FileReader FileWriter FileInputStream FileOutputStream PrintWriter")
    put(AbsentFromBrick.WINDOWS, "JFrame JPanel JButton JOptionPane Frame Graphics")
    put(AbsentFromBrick.OTHER_BRICKS, "LightSensor TouchSensor UltrasonicSensor ColorSensor DifferentialPilot")
    put(AbsentFromBrick.OTHER_BRICKS, "NXTRegulatedMotor MotorPort SensorPort")
}

/** Methods that programs for computers or other robots call with no class before them. */
private val ABSENT_CALLS = mapOf(
    "print" to AbsentFromBrick.PRINTING,
    "println" to AbsentFromBrick.PRINTING,
    "printf" to AbsentFromBrick.PRINTING,
    "readLine" to AbsentFromBrick.KEYBOARD,
    "sleep" to AbsentFromBrick.WAITING,
    "delay" to AbsentFromBrick.WAITING,
    "pause" to AbsentFromBrick.WAITING,
)

/** Beginnings of imports that lead to them. */
private val ABSENT_PACKAGES = listOf(
    "lejos." to AbsentFromBrick.OTHER_BRICKS,
    "javax.swing" to AbsentFromBrick.WINDOWS,
    "java.awt" to AbsentFromBrick.WINDOWS,
    "java.nio" to AbsentFromBrick.FILES,
    "java.text" to AbsentFromBrick.FORMATTING,
    "java.util.function" to AbsentFromBrick.RUNNABLE,
    "java.util.concurrent" to AbsentFromBrick.RUNNABLE,
    "java.util.stream" to AbsentFromBrick.COLLECTIONS,
)

/** Words that newer Java reads as commands and the brick's takes for names. */
private val NEWER_WORDS = mapOf("enum" to NewerJava.ENUM, "assert" to NewerJava.ASSERT, "var" to NewerJava.VAR)

/** [name] is a class or import, or a member of [owner]. */
internal fun absent(name: String, owner: String? = null): AbsentFromBrick? {
    if (owner != null) return ABSENT["$owner.$name"]
    return ABSENT[name.substringAfterLast('.')] ?: ABSENT_PACKAGES.firstOrNull { name.startsWith(it.first) }?.second
}

/** [method] is called with no class before it. */
internal fun absentCall(method: String): AbsentFromBrick? = ABSENT_CALLS[method]

internal fun newerWord(name: String): NewerJava? = NEWER_WORDS[name]
