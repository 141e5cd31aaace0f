package robotran.javacompiler.messages

internal object GermanNxjMessages : NxjMessages {
    override fun insteadInNxj(remedy: NxjRemedy): String = when (remedy) {
        NxjRemedy.PRINT -> {
            "System.out.println(\"hallo\") schreibt eine Zeile auf die Anzeige."
        }

        NxjRemedy.WAIT -> {
            "Thread.sleep(1000) wartet eine Sekunde, genau wie Delay.msDelay(1000) aus lejos.util."
        }

        NxjRemedy.BUTTONS -> {
            "Ein NXT hat keine Tastatur. Warte auf eine Taste: Button.waitForAnyPress()."
        }

        NxjRemedy.SORT_ARRAY -> {
            "Arrays.sort(zahlen) sortiert ein Array. Alles andere braucht eine Schleife."
        }

        NxjRemedy.HASH_MAP -> {
            "Nimm eine HashMap, und merk dir ihre Schlüssel: Ein NXT nennt sie nicht."
        }

        NxjRemedy.HASH_SET -> {
            "Nimm ein HashSet oder eine ArrayList: Keine Schleife geht auf dem NXT ein HashSet durch."
        }

        NxjRemedy.LINKED_LIST -> {
            "Nimm eine LinkedList mit addLast(), removeFirst() und removeLast()."
        }

        NxjRemedy.FILL_LIST -> {
            "Mach eine leere, zum Beispiel new ArrayList<String>(), und füg mit add() alles ein."
        }

        NxjRemedy.LOOP -> {
            "Geh die Elemente in einer Schleife durch: for (String wort : woerter)."
        }

        NxjRemedy.OWN_CLASS -> {
            "Schreib dafür ein eigenes Interface oder eine eigene Klasse."
        }

        NxjRemedy.NULL -> {
            "Nimm null für das, was fehlen kann."
        }

        NxjRemedy.JOIN_TEXTS -> {
            "Verbinde Texte mit \"+\". LCD.drawInt(zahl, 4, 0, 0) schreibt auf vier Plätze."
        }

        NxjRemedy.TOKENIZER -> {
            "Ein StringTokenizer aus java.util zerlegt einen Text: new StringTokenizer(text, \" \")."
        }

        NxjRemedy.COMPARE_TEXTS -> {
            "Ein Text hat auf dem NXT equals(), startsWith(), indexOf(), substring() und trim()."
        }

        NxjRemedy.INDEX_OF -> {
            "Schreib text.indexOf(\"teil\") >= 0."
        }

        NxjRemedy.SUBSTRINGS -> {
            "Mach einen neuen Text aus Teilen: text.substring(0, 2) + \"neu\" + text.substring(2)."
        }

        NxjRemedy.COMPARE_CHARACTERS -> {
            "Vergleich es: zeichen >= 'a' && zeichen <= 'z'."
        }

        NxjRemedy.CALCULATE -> {
            "Rechne es mit dem aus, was Math hier hat: Math.sqrt, Math.floor, Math.pow und andere."
        }

        NxjRemedy.ARRAY_LOOP -> {
            "Geh das Array in einem \"for\" durch. System.arraycopy kopiert Elemente."
        }

        NxjRemedy.THREADS -> {
            "Schreib \"extends Thread\" oder \"implements Runnable\" und teil mit \"synchronized\"."
        }

        NxjRemedy.END_THREAD -> {
            "Lass run() eine Variable ansehen, die der andere Thread setzt, und dann enden."
        }

        NxjRemedy.STOPWATCH -> {
            "System.currentTimeMillis() ist die Zeit. Eine Stopwatch aus lejos.util misst."
        }

        NxjRemedy.LONG_OR_DOUBLE -> {
            "Nimm \"long\" für große ganze Zahlen und \"double\" für andere."
        }

        NxjRemedy.RANDOM -> {
            "Nimm new Random() aus java.util."
        }

        NxjRemedy.INSTANCEOF -> {
            "Ein NXT vergisst die Namen der Klassen. Was etwas ist, sagt \"instanceof\"."
        }

        NxjRemedy.LCD -> {
            "Ein NXT hat keine Fenster. Er zeigt Texte mit LCD.drawString(\"hallo\", 0, 0)."
        }

        NxjRemedy.PIXELS -> {
            "LCD.setPixel(x, y, 1) zeichnet einen Punkt."
        }

        NxjRemedy.FILE_STREAMS -> {
            "Nimm einen FileInputStream oder einen FileOutputStream aus java.io."
        }

        NxjRemedy.DATA_STREAMS -> {
            "Ein DataOutputStream schreibt Zahlen und Texte, ein DataInputStream liest sie."
        }

        NxjRemedy.BLUETOOTH -> {
            "Roboter sprechen über Bluetooth, siehe die Klasse Bluetooth in lejos.nxt.comm."
        }

        NxjRemedy.BLUETOOTH_BY_NAME -> {
            "Verbinde Roboter mit Namen: Bluetooth.connect(\"red\", NXTConnection.RAW)."
        }

        NxjRemedy.LINE_FEED -> {
            "Schreib \"\\n\"."
        }

        NxjRemedy.NXT_MOTOR -> {
            "Die Leistung setzt du mit new NXTMotor(MotorPort.A). Motor.A hat setSpeed()."
        }

        NxjRemedy.ALWAYS_REGULATED -> {
            "Lass es weg: Der Motor hält sein Tempo schon. setAcceleration() macht ihn sanft."
        }

        NxjRemedy.MOTOR_DIRECTIONS -> {
            "Ein Motor hat forward(), backward() und stop(), zum Beispiel Motor.A.forward();"
        }

        NxjRemedy.MOTOR_ROTATE -> {
            "rotate(90) dreht einen Motor um 90 Grad."
        }

        NxjRemedy.ROTATION_SPEED -> {
            "Das heißt jetzt getRotationSpeed()."
        }

        NxjRemedy.IS_MOVING -> {
            "Das heißt jetzt isMoving()."
        }

        NxjRemedy.DIFFERENTIAL_PILOT -> {
            "Nimm new DifferentialPilot(raddurchmesser, spurweite, Motor.A, Motor.C)."
        }

        NxjRemedy.PILOT_SPEEDS -> {
            "Ein Pilot hat setTravelSpeed() und setRotateSpeed()."
        }

        NxjRemedy.NAVIGATOR -> {
            "Nimm einen Navigator aus lejos.robotics.navigation."
        }

        NxjRemedy.ODOMETRY -> {
            "Karten gibt es hier nicht. Ein OdometryPoseProvider weiß, wo der Roboter ist."
        }

        NxjRemedy.SENSORS -> {
            "Es gibt LEGOs Sensoren in lejos.nxt und die in lejos.nxt.addon, die du bauen kannst."
        }

        NxjRemedy.COMPASS -> {
            "Es gibt CompassHTSensor und CompassMindSensor in lejos.nxt.addon."
        }

        NxjRemedy.GYRO -> {
            "Es gibt GyroSensor in lejos.nxt.addon."
        }

        NxjRemedy.ACCELERATION -> {
            "Es gibt AccelHTSensor und AccelMindSensor in lejos.nxt.addon."
        }

        NxjRemedy.DISTANCE -> {
            "Abstände messen UltrasonicSensor und OpticalDistanceSensor aus lejos.nxt.addon."
        }

        NxjRemedy.COUNT_TURNS -> {
            "Motor.A.getTachoCount() zählt Grad, ein RCXRotationSensor Schritte einer Achse."
        }

        NxjRemedy.THERMOMETER -> {
            "Nimm RCXThermometer aus lejos.nxt.addon oder TemperatureSensor aus lejos.nxt."
        }

        NxjRemedy.RCX_LINK -> {
            "Mit einem RCX spricht ein RCXLink aus lejos.nxt.addon: link.sendF7(3), link.A.forward()."
        }

        NxjRemedy.ONE_PORT_EACH -> {
            "Jeder Sensor braucht einen eigenen Anschluss, S1 bis S4."
        }

        NxjRemedy.MENU_SETTINGS -> {
            "Lass es weg: Was im Menü eingestellt ist, gilt schon."
        }

        NxjRemedy.NXT_LISTENERS -> {
            "Nimm Listener: Button.ENTER.addButtonListener(..), SensorPort.S1.addSensorPortListener(..)."
        }

        NxjRemedy.BREAKPOINTS -> {
            "Ein Programm kann nicht in den Stein schauen. Haltepunkte zeigen Threads und Variablen."
        }

        NxjRemedy.THREE_MOTORS -> {
            "Es gibt nur die Motoren an den Anschlüssen des Steins: Motor.A, Motor.B und Motor.C."
        }

        NxjRemedy.NOT_EV3 -> {
            "Das ist für einen EV3. Dieser Roboter hat einen NXT: import lejos.nxt.*;"
        }

        NxjRemedy.MOTOR_OF_PORT -> {
            "Das ist für einen EV3. Der Motor am Anschluss A eines NXT ist Motor.A."
        }

        NxjRemedy.NOT_RCX -> {
            "Das ist für einen RCX. Dieser Roboter hat einen NXT: import lejos.nxt.*;"
        }

        NxjRemedy.DRAW -> {
            "LCD.drawInt(7, 0, 0) zeigt eine Zahl und LCD.drawString(\"hallo\", 0, 1) einen Text."
        }

        NxjRemedy.SENSOR_PORT -> {
            "Ein NXT hat für jeden Sensor eine Klasse: new TouchSensor(SensorPort.S1)."
        }

        NxjRemedy.NXT_BUTTONS -> {
            "Ein NXT hat Button.ENTER, Button.LEFT, Button.RIGHT und Button.ESCAPE."
        }
    }

    override fun textsCompared(operator: String): String =
        "\"$operator\" fragt, ob beide dasselbe Objekt sind. Ein NXT macht für jeden Text jedes Mal ein neues."

    override fun compareLetters(comparison: String): String = "Vergleich die Buchstaben: $comparison."
}
