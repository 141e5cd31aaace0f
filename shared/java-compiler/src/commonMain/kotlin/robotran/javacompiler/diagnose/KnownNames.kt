package robotran.javacompiler.diagnose

import robotran.javacompiler.messages.NewerJava
import robotran.javacompiler.messages.UnsupportedOnBrick

/** Classes, and methods with their class, that programs for computers use and the brick does not have. */
private val ABSENT: Map<String, UnsupportedOnBrick> = buildMap {
    fun put(what: UnsupportedOnBrick, names: String) = names.split(' ').forEach { put(it, what) }
    put(UnsupportedOnBrick.PRINTING, "System.out System.err PrintStream")
    put(UnsupportedOnBrick.KEYBOARD, "System.in Scanner BufferedReader InputStreamReader Console")
    put(
        UnsupportedOnBrick.COLLECTIONS,
        "ArrayList List LinkedList Collection Collections Map HashMap TreeMap LinkedHashMap",
    )
    put(UnsupportedOnBrick.COLLECTIONS, "Set HashSet TreeSet Iterator Iterable")
    put(UnsupportedOnBrick.COLLECTIONS, "Enumeration Arrays Deque ArrayDeque Comparable Comparator")
    put(UnsupportedOnBrick.RUNNABLE, "Runnable Callable ExecutorService Executors")
    put(UnsupportedOnBrick.FORMATTING, "String.format Formatter DecimalFormat NumberFormat")
    put(UnsupportedOnBrick.TEXT_METHODS, "String.substring String.indexOf String.compareTo")
    put(UnsupportedOnBrick.TEXT_METHODS, "String.split String.trim String.isEmpty")
    put(UnsupportedOnBrick.TEXT_METHODS, "String.toUpperCase String.toLowerCase")
    put(UnsupportedOnBrick.TEXT_METHODS, "String.equalsIgnoreCase String.replace String.contains")
    put(UnsupportedOnBrick.TEXT_METHODS, "String.startsWith String.endsWith String.lastIndexOf String.concat")
    put(UnsupportedOnBrick.TEXT_METHODS, "String.matches String.replaceAll")
    put(UnsupportedOnBrick.TEXT_METHODS, "String.getBytes String.compareToIgnoreCase String.intern")
    put(UnsupportedOnBrick.VECTOR_METHODS, "Vector.add Vector.get Vector.set Vector.remove Vector.contains")
    put(UnsupportedOnBrick.VECTOR_METHODS, "Vector.firstElement Vector.lastElement")
    put(UnsupportedOnBrick.VECTOR_METHODS, "Vector.iterator Vector.elements Vector.removeAll")
    put(UnsupportedOnBrick.HASHTABLE_METHODS, "Hashtable.containsKey Hashtable.contains Hashtable.containsValue")
    put(UnsupportedOnBrick.HASHTABLE_METHODS, "Hashtable.remove Hashtable.size Hashtable.keys")
    put(UnsupportedOnBrick.HASHTABLE_METHODS, "Hashtable.isEmpty Hashtable.clear Hashtable.keySet")
    put(UnsupportedOnBrick.WRITING_NUMBERS, "String.valueOf Integer.toHexString")
    put(UnsupportedOnBrick.WRITING_NUMBERS, "Integer.toBinaryString Float.toString Integer.intValue")
    put(UnsupportedOnBrick.SYSTEM_METHODS, "System.nanoTime System.gc System.identityHashCode System.getProperty")
    put(UnsupportedOnBrick.ARRAY_COPYING, "System.arraycopy")
    put(
        UnsupportedOnBrick.PARSING,
        "Integer.parseInt Integer.valueOf Integer.decode Float.parseFloat Double.parseDouble",
    )
    put(UnsupportedOnBrick.WRAPPERS, "Boolean Byte Character Short Long Double Number BigInteger BigDecimal")
    put(UnsupportedOnBrick.FILES, "File FileReader FileWriter FileInputStream FileOutputStream PrintWriter")
    put(UnsupportedOnBrick.WINDOWS, "JFrame JPanel JButton JOptionPane Frame Graphics")
    put(UnsupportedOnBrick.MOTOR_DIRECTIONS, "Motor.run Motor.start Motor.on Motor.turnOn Motor.go Motor.drive")
    put(UnsupportedOnBrick.MOTOR_DIRECTIONS, "Motor.move Motor.off Motor.turnOff Motor.brake")
    put(UnsupportedOnBrick.MOTOR_TIME, "Motor.rotate Motor.rotateTo Motor.turn Motor.getTachoCount")
    put(UnsupportedOnBrick.MOTOR_TIME, "Motor.resetTachoCount")
    put(UnsupportedOnBrick.MOTOR_POWER, "Motor.setSpeed Motor.speed Motor.power")
    put(UnsupportedOnBrick.OTHER_BRICKS, "LightSensor TouchSensor UltrasonicSensor ColorSensor DifferentialPilot")
    put(UnsupportedOnBrick.OTHER_BRICKS, "NXTRegulatedMotor MotorPort SensorPort")
}

/** Methods that programs for computers or other robots call without a qualifier. */
private val ABSENT_CALLS = mapOf(
    "print" to UnsupportedOnBrick.PRINTING,
    "println" to UnsupportedOnBrick.PRINTING,
    "printf" to UnsupportedOnBrick.PRINTING,
    "readLine" to UnsupportedOnBrick.KEYBOARD,
    "sleep" to UnsupportedOnBrick.WAITING,
    "delay" to UnsupportedOnBrick.WAITING,
    "pause" to UnsupportedOnBrick.WAITING,
)

/** The prefixes of imports that the brick does not have. */
private val ABSENT_PACKAGES = listOf(
    "lejos." to UnsupportedOnBrick.OTHER_BRICKS,
    "javax.swing" to UnsupportedOnBrick.WINDOWS,
    "java.awt" to UnsupportedOnBrick.WINDOWS,
    "java.nio" to UnsupportedOnBrick.FILES,
    "java.text" to UnsupportedOnBrick.FORMATTING,
    "java.util.function" to UnsupportedOnBrick.RUNNABLE,
    "java.util.concurrent" to UnsupportedOnBrick.RUNNABLE,
    "java.util.stream" to UnsupportedOnBrick.COLLECTIONS,
)

/** Keywords of newer Java that are identifiers in the brick's Java. */
private val NEWER_WORDS = mapOf("enum" to NewerJava.ENUM, "assert" to NewerJava.ASSERT, "var" to NewerJava.VAR)

/** Returns the missing feature of [name], a class, an import or a member of [owner]; null if it is unknown. */
internal fun absent(name: String, owner: String? = null): UnsupportedOnBrick? {
    if (owner != null) return ABSENT["$owner.$name"]
    return ABSENT[name.substringAfterLast('.')] ?: ABSENT_PACKAGES.firstOrNull { name.startsWith(it.first) }?.second
}

/** Returns the missing feature of a call of [method] without a qualifier; null if it is unknown. */
internal fun absentCall(method: String): UnsupportedOnBrick? = ABSENT_CALLS[method]

internal fun newerFeature(name: String): NewerJava? = NEWER_WORDS[name]
