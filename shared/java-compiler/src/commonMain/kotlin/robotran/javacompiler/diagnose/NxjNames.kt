package robotran.javacompiler.diagnose

import robotran.javacompiler.messages.NxjRemedy

/** Classes, and members with their class, that other programs use and an NXT with leJOS NXJ does not have. */
private val ABSENT: Map<String, NxjRemedy> = buildMap {
    fun put(remedy: NxjRemedy, names: String) = names.split(' ').forEach { put(it, remedy) }
    put(NxjRemedy.BUTTONS, "System.in System.console Scanner Console")
    put(NxjRemedy.SORT_ARRAY, "Collections Comparator ArrayList.sort LinkedList.sort Vector.sort List.sort")
    put(NxjRemedy.HASH_MAP, "TreeMap LinkedHashMap SortedMap NavigableMap")
    put(NxjRemedy.HASH_MAP, "EnumMap ConcurrentHashMap WeakHashMap Dictionary")
    put(NxjRemedy.HASH_SET, "TreeSet LinkedHashSet SortedSet NavigableSet EnumSet")
    put(NxjRemedy.LINKED_LIST, "Deque ArrayDeque PriorityQueue BlockingQueue ConcurrentLinkedQueue LinkedBlockingQueue")
    put(NxjRemedy.FILL_LIST, "List.of Set.of Map.of Arrays.asList")
    for (collection in listOf("ArrayList", "LinkedList", "List", "Set", "HashSet", "Collection")) {
        put(NxjRemedy.LOOP, "$collection.forEach $collection.stream $collection.removeIf $collection.replaceAll")
    }
    put(NxjRemedy.LOOP, "Stream IntStream Collectors HashMap.forEach Map.forEach HashMap.getOrDefault Map.getOrDefault")
    put(NxjRemedy.LOOP, "HashMap.computeIfAbsent HashMap.merge HashMap.putIfAbsent Map.putIfAbsent Map.merge")
    put(NxjRemedy.OWN_CLASS, "Function BiFunction Supplier Consumer BiConsumer Predicate UnaryOperator IntFunction")
    put(NxjRemedy.OWN_CLASS, "Objects Observer Observable EventListener PropertyChangeListener")
    put(NxjRemedy.NULL, "Optional OptionalInt OptionalDouble")
    put(NxjRemedy.JOIN_TEXTS, "String.format String.join String.repeat")
    put(NxjRemedy.JOIN_TEXTS, "String.formatted PrintStream.printf PrintStream.format")
    put(NxjRemedy.JOIN_TEXTS, "Formatter DecimalFormat NumberFormat MessageFormat SimpleDateFormat Locale StringJoiner")
    put(NxjRemedy.TOKENIZER, "String.split StreamTokenizer")
    put(NxjRemedy.COMPARE_TEXTS, "String.matches String.replaceAll String.replaceFirst Pattern Matcher String.strip")
    put(NxjRemedy.COMPARE_TEXTS, "String.isBlank String.lines")
    put(NxjRemedy.COMPARE_TEXTS, "String.chars String.compareToIgnoreCase String.regionMatches")
    put(NxjRemedy.COMPARE_TEXTS, "String.stripLeading String.stripTrailing")
    put(NxjRemedy.INDEX_OF, "String.contains")
    for (builder in listOf("StringBuilder", "StringBuffer")) {
        put(NxjRemedy.SUBSTRINGS, "$builder.insert $builder.reverse $builder.replace")
    }
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.isLetter Character.isLetterOrDigit")
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.isUpperCase Character.isLowerCase")
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.isWhitespace Character.toUpperCase")
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.toLowerCase Character.isAlphabetic")
    put(NxjRemedy.COMPARE_CHARACTERS, "Character.getNumericValue Character.isSpaceChar")
    put(NxjRemedy.CALCULATE, "Math.floorMod Math.floorDiv Math.hypot Math.cbrt")
    put(NxjRemedy.CALCULATE, "Math.log10 Math.sinh Math.cosh Math.tanh Math.clamp")
    put(NxjRemedy.CALCULATE, "Math.addExact Math.multiplyExact Math.subtractExact")
    put(NxjRemedy.CALCULATE, "Math.toIntExact Math.ulp Math.expm1 Math.log1p")
    put(NxjRemedy.CALCULATE, "StrictMath Integer.compare Integer.max")
    put(NxjRemedy.CALCULATE, "Integer.min Integer.sum Long.compare Boolean.compare")
    put(NxjRemedy.ARRAY_LOOP, "Arrays.stream Arrays.hashCode Arrays.deepToString Arrays.deepEquals Arrays.setAll")
    put(NxjRemedy.THREADS, "Executor ExecutorService Executors Callable")
    put(NxjRemedy.THREADS, "Future CompletableFuture CountDownLatch Semaphore")
    put(NxjRemedy.THREADS, "Lock ReentrantLock AtomicInteger AtomicBoolean")
    put(NxjRemedy.THREADS, "AtomicLong AtomicReference TimeUnit ThreadLocal")
    put(NxjRemedy.THREADS, "ThreadGroup CyclicBarrier ConcurrentMap")
    put(NxjRemedy.END_THREAD, "Thread.stop Thread.suspend Thread.resume Thread.destroy")
    put(NxjRemedy.STOPWATCH, "Date.getTime Date.setTime")
    put(NxjRemedy.BITS, "BitSet.and BitSet.andNot BitSet.or BitSet.xor BitSet.intersects")
    put(NxjRemedy.NO_FOLDERS, "File.isDirectory File.mkdir File.mkdirs File.getParent File.list")
    put(NxjRemedy.OTHER_PROGRAM, "File.exec")
    put(NxjRemedy.OWN_VARIABLE, "RegulatedMotor.getAcceleration MirrorMotor.getAcceleration")
    put(NxjRemedy.CALCULATE, "Math.nextUp")
    put(NxjRemedy.BITS, "BitSet.nextSetBit BitSet.nextClearBit")
    put(NxjRemedy.STOPWATCH, "Calendar GregorianCalendar LocalDate LocalTime LocalDateTime Instant Duration")
    put(NxjRemedy.LONG_OR_DOUBLE, "BigInteger BigDecimal")
    put(NxjRemedy.RANDOM, "SecureRandom ThreadLocalRandom UUID SplittableRandom")
    put(NxjRemedy.INSTANCEOF, "Class.getName Class.getSimpleName")
    put(NxjRemedy.INSTANCEOF, "Class.newInstance Class.getMethods Class.getDeclaredFields")
    put(NxjRemedy.LCD, "JFrame JPanel JButton JLabel JOptionPane Frame Canvas Color.getRGB SwingUtilities")
    put(NxjRemedy.PIXELS, "Graphics Graphics2D LCD.drawLine LCD.drawRect LCD.fillRect LCD.drawArc Image Font")
    put(NxjRemedy.FILE_STREAMS, "FileReader FileWriter PrintWriter RandomAccessFile Files Path.of Paths")
    put(NxjRemedy.DATA_STREAMS, "ObjectOutputStream ObjectInputStream Externalizable StringReader StringWriter")
    put(NxjRemedy.BLUETOOTH, "Socket ServerSocket URL InetAddress NXTCommand RemoteMotor RemoteNXT RS485 LCP InBox")
    put(NxjRemedy.LINE_FEED, "System.lineSeparator System.getenv")
    put(NxjRemedy.NXT_MOTOR, "NXTRegulatedMotor.setPower NXTRegulatedMotor.getPower RegulatedMotor.setPower")
    put(NxjRemedy.ALWAYS_REGULATED, "NXTRegulatedMotor.regulateSpeed NXTRegulatedMotor.smoothAcceleration")
    put(NxjRemedy.ALWAYS_REGULATED, "NXTRegulatedMotor.isRegulating NXTRegulatedMotor.setBrakePower")
    for (motor in listOf("NXTRegulatedMotor", "RegulatedMotor", "NXTMotor")) {
        put(NxjRemedy.MOTOR_DIRECTIONS, "$motor.run $motor.start $motor.on $motor.turnOn $motor.go $motor.drive")
        put(NxjRemedy.MOTOR_DIRECTIONS, "$motor.move $motor.off $motor.turnOff $motor.brake")
    }
    put(NxjRemedy.MOTOR_ROTATE, "NXTRegulatedMotor.turn RegulatedMotor.turn NXTRegulatedMotor.rotateFor")
    put(NxjRemedy.ROTATION_SPEED, "NXTRegulatedMotor.getActualSpeed RegulatedMotor.getActualSpeed")
    put(NxjRemedy.IS_MOVING, "NXTRegulatedMotor.isRotating RegulatedMotor.isRotating NXTRegulatedMotor.isForward")
    put(NxjRemedy.IS_MOVING, "NXTRegulatedMotor.isBackward NXTRegulatedMotor.isStopped NXTRegulatedMotor.isFloating")
    put(NxjRemedy.DIFFERENTIAL_PILOT, "Pilot TachoPilot LegacyPilot CompassPilot")
    put(NxjRemedy.DIFFERENTIAL_PILOT, "SegowayPilot Segoway MovePilot WheeledChassis")
    put(NxjRemedy.DIFFERENTIAL_PILOT, "Chassis OmniPilot SteeringPilot TwoWheelPilot")
    put(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot.setMoveSpeed")
    put(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot.setSpeed DifferentialPilot.setTurnSpeed")
    put(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot.setLinearSpeed")
    put(NxjRemedy.PILOT_SPEEDS, "DifferentialPilot.setAngularSpeed DifferentialPilot.getMoveSpeed")
    put(NxjRemedy.NAVIGATOR, "SimpleNavigator TachoNavigator LegacyNavigator CompassNavigator NavPathController")
    put(NxjRemedy.ODOMETRY, "MCLPoseProvider MCLParticleSet LineMap RangeMap OccupancyGridMap ShortestPathFinder")
    put(NxjRemedy.ODOMETRY, "NodePathFinder FourWayGridMesh AstarSearchAlgorithm BeaconPoseProvider KalmanFilter")
    put(NxjRemedy.SENSORS, "AccelHTSensor AccelMindSensor ColorHTSensor IRSeeker")
    put(NxjRemedy.SENSORS, "IRSeekerV2 IRLink EOPD TiltSensor NXTCam")
    put(NxjRemedy.SENSORS, "OpticalDistanceSensor AngleSensor PressureSensor")
    put(NxjRemedy.SENSORS, "RFIDSensor BarometricSensor TouchMUX PFLink")
    put(NxjRemedy.NOT_EV3, "LocalEV3 BrickFinder EV3 SampleProvider GraphicsLCD TextLCD EV3TouchSensor EV3ColorSensor")
    put(NxjRemedy.NOT_EV3, "EV3UltrasonicSensor EV3GyroSensor EV3IRSensor NXTTouchSensor NXTUltrasonicSensor Keys LED")
    put(NxjRemedy.MOTOR_OF_PORT, "EV3LargeRegulatedMotor EV3MediumRegulatedMotor UnregulatedMotor")
    put(NxjRemedy.DRAW, "LCD.showNumber LCD.setNumber LCD.showProgramNumber LCD.setSegment LCD.print LCD.println")
    put(NxjRemedy.SENSOR_PORT, "Sensor SensorConstants.SENSOR_TYPE_LIGHT Sensor.S1 Sensor.S2 Sensor.S3 ProximitySensor")
    put(NxjRemedy.NXT_BUTTONS, "Button.RUN Button.VIEW Button.PRGM Button.UP Button.DOWN")
    put(NxjRemedy.BLUETOOTH, "Serial RCXPort PacketHandler")
}

/** Methods that other programs call without a class or an object. */
private val ABSENT_CALLS = mapOf(
    "print" to NxjRemedy.PRINT,
    "println" to NxjRemedy.PRINT,
    "printf" to NxjRemedy.PRINT,
    "readLine" to NxjRemedy.BUTTONS,
    "input" to NxjRemedy.BUTTONS,
    "sleep" to NxjRemedy.WAIT,
    "delay" to NxjRemedy.WAIT,
    "pause" to NxjRemedy.WAIT,
    "msDelay" to NxjRemedy.WAIT,
    "waitForAnyPress" to NxjRemedy.BUTTONS,
)

/** The beginnings of imports that an NXT with leJOS NXJ does not have. */
private val ABSENT_PACKAGES = listOf(
    "josx" to NxjRemedy.NOT_RCX,
    "lejos.hardware" to NxjRemedy.NOT_EV3,
    "lejos.remote" to NxjRemedy.NOT_EV3,
    "lejos.robotics.chassis" to NxjRemedy.DIFFERENTIAL_PILOT,
    "lejos.robotics.mapping" to NxjRemedy.ODOMETRY,
    "lejos.robotics.filter" to NxjRemedy.SENSORS,
    "lejos.robotics.kinematics" to NxjRemedy.DIFFERENTIAL_PILOT,
    "lejos.nxt.addon" to NxjRemedy.SENSORS,
    "lejos.nxt.remote" to NxjRemedy.BLUETOOTH,
    "lejos.pc" to NxjRemedy.BLUETOOTH,
    "javax.microedition.lcdui" to NxjRemedy.PIXELS,
    "javax.bluetooth" to NxjRemedy.BLUETOOTH,
    "javax.swing" to NxjRemedy.LCD,
    "java.awt" to NxjRemedy.LCD,
    "java.net" to NxjRemedy.BLUETOOTH,
    "java.nio" to NxjRemedy.FILE_STREAMS,
    "java.text" to NxjRemedy.JOIN_TEXTS,
    "java.time" to NxjRemedy.STOPWATCH,
    "java.math" to NxjRemedy.LONG_OR_DOUBLE,
    "java.lang.reflect" to NxjRemedy.INSTANCEOF,
    "java.util.function" to NxjRemedy.OWN_CLASS,
    "java.util.concurrent" to NxjRemedy.THREADS,
    "java.util.stream" to NxjRemedy.LOOP,
    "java.util.regex" to NxjRemedy.COMPARE_TEXTS,
)

/** What a program does without [name], a class, an import or a member of [owner]; null if nothing is known. */
internal fun nxjRemedy(name: String, owner: String? = null): NxjRemedy? {
    if (owner != null) return ABSENT["$owner.$name"]
    val ofClass = ABSENT[name.substringAfterLast('.')]
    return ofClass ?: ABSENT_PACKAGES.firstOrNull { (start, _) -> name == start || name.startsWith("$start.") }?.second
}

/** What a program does without [method], which it calls without a class or an object; null if nothing is known. */
internal fun nxjRemedyOfCall(method: String): NxjRemedy? = ABSENT_CALLS[method]

/** The names in this table: classes, and members with their class. */
internal val namesAbsentFromNxj: Set<String> get() = ABSENT.keys
