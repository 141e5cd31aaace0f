package robotran.javacompiler.messages

internal object EnglishNxjMessages : NxjMessages {
    override fun insteadInNxj(remedy: NxjRemedy): String = when (remedy) {
        NxjRemedy.PRINT -> {
            "System.out.println(\"hello\") writes a line on the display."
        }

        NxjRemedy.WAIT -> {
            "Thread.sleep(1000) waits a second, and so does Delay.msDelay(1000) of lejos.util."
        }

        NxjRemedy.BUTTONS -> {
            "An NXT has no keyboard. Wait for a button: Button.waitForAnyPress()."
        }

        NxjRemedy.SORT_ARRAY -> {
            "Arrays.sort(numbers) sorts an array. Anything else takes a loop."
        }

        NxjRemedy.HASH_MAP -> {
            "Use a HashMap, and keep its keys in an ArrayList: an NXT cannot tell them."
        }

        NxjRemedy.HASH_SET -> {
            "Use a HashSet, or an ArrayList: on an NXT, no loop can go through a HashSet."
        }

        NxjRemedy.LINKED_LIST -> {
            "Use a LinkedList with addLast(), removeFirst() and removeLast()."
        }

        NxjRemedy.FILL_LIST -> {
            "Make an empty one, such as new ArrayList<String>(), and add() each element."
        }

        NxjRemedy.LOOP -> {
            "Go through the elements in a loop: for (String word : words)."
        }

        NxjRemedy.OWN_CLASS -> {
            "Write an interface or a class of your own for it."
        }

        NxjRemedy.NULL -> {
            "Use null for what may be missing."
        }

        NxjRemedy.JOIN_TEXTS -> {
            "Join texts with \"+\". LCD.drawInt(number, 4, 0, 0) writes a number in four places."
        }

        NxjRemedy.TOKENIZER -> {
            "A StringTokenizer of java.util takes a text apart: new StringTokenizer(text, \" \")."
        }

        NxjRemedy.COMPARE_TEXTS -> {
            "A text on an NXT has equals(), startsWith(), indexOf(), substring() and trim()."
        }

        NxjRemedy.INDEX_OF -> {
            "Write text.indexOf(\"part\") >= 0."
        }

        NxjRemedy.SUBSTRINGS -> {
            "Make a new text of parts: text.substring(0, 2) + \"new\" + text.substring(2)."
        }

        NxjRemedy.COMPARE_CHARACTERS -> {
            "Compare it: letter >= 'a' && letter <= 'z'."
        }

        NxjRemedy.CALCULATE -> {
            "Calculate it with what Math has here, such as Math.sqrt, Math.floor and Math.pow."
        }

        NxjRemedy.ARRAY_LOOP -> {
            "Go through the array in a \"for\". System.arraycopy copies elements."
        }

        NxjRemedy.THREADS -> {
            "Write \"extends Thread\" or \"implements Runnable\", and share with \"synchronized\"."
        }

        NxjRemedy.END_THREAD -> {
            "Let run() look at a variable that the other thread sets, and return."
        }

        NxjRemedy.STOPWATCH -> {
            "System.currentTimeMillis() is the time. A Stopwatch of lejos.util measures."
        }

        NxjRemedy.LONG_OR_DOUBLE -> {
            "Use \"long\" for large whole numbers and \"double\" for others."
        }

        NxjRemedy.RANDOM -> {
            "Use new Random() of java.util."
        }

        NxjRemedy.INSTANCEOF -> {
            "An NXT forgets the names of classes. \"instanceof\" says what something is."
        }

        NxjRemedy.LCD -> {
            "An NXT has no windows. It shows texts with LCD.drawString(\"hello\", 0, 0)."
        }

        NxjRemedy.PIXELS -> {
            "LCD.setPixel(x, y, 1) draws a dot."
        }

        NxjRemedy.FILE_STREAMS -> {
            "Use a FileInputStream or a FileOutputStream of java.io."
        }

        NxjRemedy.DATA_STREAMS -> {
            "A DataOutputStream writes numbers and texts, and a DataInputStream reads them."
        }

        NxjRemedy.BLUETOOTH -> {
            "Robots talk by Bluetooth, see the class Bluetooth of lejos.nxt.comm."
        }

        NxjRemedy.BLUETOOTH_BY_NAME -> {
            "Robots here connect by name: Bluetooth.connect(\"red\", NXTConnection.RAW)."
        }

        NxjRemedy.LINE_FEED -> {
            "Write \"\\n\"."
        }

        NxjRemedy.NXT_MOTOR -> {
            "A motor whose power you set is new NXTMotor(MotorPort.A). Motor.A has setSpeed()."
        }

        NxjRemedy.ALWAYS_REGULATED -> {
            "Leave it out: the motor keeps its speed. setAcceleration() makes it gentle."
        }

        NxjRemedy.MOTOR_DIRECTIONS -> {
            "A motor has forward(), backward() and stop(), such as Motor.A.forward();"
        }

        NxjRemedy.MOTOR_ROTATE -> {
            "rotate(90) turns a motor by 90 degrees."
        }

        NxjRemedy.ROTATION_SPEED -> {
            "It is getRotationSpeed() now."
        }

        NxjRemedy.IS_MOVING -> {
            "It is isMoving() now."
        }

        NxjRemedy.DIFFERENTIAL_PILOT -> {
            "Use new DifferentialPilot(wheelDiameter, trackWidth, Motor.A, Motor.C)."
        }

        NxjRemedy.PILOT_SPEEDS -> {
            "A pilot has setTravelSpeed() and setRotateSpeed()."
        }

        NxjRemedy.NAVIGATOR -> {
            "Use a Navigator of lejos.robotics.navigation."
        }

        NxjRemedy.ODOMETRY -> {
            "There are no maps here. An OdometryPoseProvider knows where the robot is."
        }

        NxjRemedy.SENSORS -> {
            "There are LEGO's sensors in lejos.nxt, and those of lejos.nxt.addon that you can build."
        }

        NxjRemedy.COMPASS -> {
            "There are CompassHTSensor and CompassMindSensor of lejos.nxt.addon."
        }

        NxjRemedy.GYRO -> {
            "There is GyroSensor of lejos.nxt.addon."
        }

        NxjRemedy.ACCELERATION -> {
            "There are AccelHTSensor and AccelMindSensor of lejos.nxt.addon."
        }

        NxjRemedy.DISTANCE -> {
            "UltrasonicSensor and OpticalDistanceSensor of lejos.nxt.addon measure distances."
        }

        NxjRemedy.COUNT_TURNS -> {
            "Motor.A.getTachoCount() counts degrees, an RCXRotationSensor steps of an axle."
        }

        NxjRemedy.THERMOMETER -> {
            "Use RCXThermometer of lejos.nxt.addon, or TemperatureSensor of lejos.nxt."
        }

        NxjRemedy.RCX_LINK -> {
            "Use an RCXLink of lejos.nxt.addon to talk to an RCX: link.sendF7(3), link.A.forward()."
        }

        NxjRemedy.ONE_PORT_EACH -> {
            "Each sensor needs a port of its own, S1 to S4."
        }

        NxjRemedy.MENU_SETTINGS -> {
            "Leave it out: what is set in the menu holds already."
        }

        NxjRemedy.NXT_LISTENERS -> {
            "Use listeners: Button.ENTER.addButtonListener(..), SensorPort.S1.addSensorPortListener(..)."
        }

        NxjRemedy.BREAKPOINTS -> {
            "A program cannot look into the brick. Breakpoints show its threads and variables."
        }

        NxjRemedy.THREE_MOTORS -> {
            "There are only the motors on the ports of the brick: Motor.A, Motor.B and Motor.C."
        }

        NxjRemedy.NOT_EV3 -> {
            "That is for an EV3. This robot has an NXT: import lejos.nxt.*;"
        }

        NxjRemedy.MOTOR_OF_PORT -> {
            "That is for an EV3. The motor on port A of an NXT is Motor.A."
        }

        NxjRemedy.NOT_RCX -> {
            "That is for an RCX. This robot has an NXT: import lejos.nxt.*;"
        }

        NxjRemedy.DRAW -> {
            "LCD.drawInt(7, 0, 0) shows a number, and LCD.drawString(\"hello\", 0, 1) shows a text."
        }

        NxjRemedy.SENSOR_PORT -> {
            "An NXT has a class for each sensor, such as new TouchSensor(SensorPort.S1)."
        }

        NxjRemedy.NXT_BUTTONS -> {
            "An NXT has Button.ENTER, Button.LEFT, Button.RIGHT and Button.ESCAPE."
        }
    }

    override fun textsCompared(operator: String): String =
        "\"$operator\" asks whether both are the same object. An NXT makes a new one each time a text is used."

    override fun compareLetters(comparison: String): String = "Compare the letters: $comparison."
}
