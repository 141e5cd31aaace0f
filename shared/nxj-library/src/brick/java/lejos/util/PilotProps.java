package lejos.util;

import java.io.File;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.util.Properties;
import lejos.nxt.Motor;
import lejos.robotics.RegulatedMotor;

/** What a program has to know of a robot, kept in the file pilot.props. */
public class PilotProps extends Properties {
    /** The name of the file. */
    public static final String PERSISTENT_FILENAME = "pilot.props";

    /** The name of the diameter of the wheels. */
    public static final String KEY_WHEELDIAMETER = "wheelDiameter";

    /** The name of the distance between the wheels. */
    public static final String KEY_TRACKWIDTH = "trackWidth";

    /** The name of the left motor. */
    public static final String KEY_LEFTMOTOR = "leftMotor";

    /** The name of the right motor. */
    public static final String KEY_RIGHTMOTOR = "rightMotor";

    /** The name of whether the motors drive the robot backward. */
    public static final String KEY_REVERSE = "reverse";

    /** Makes one without anything. */
    public PilotProps() {
    }

    /** Reads the file, if there is one. */
    public void loadPersistentValues() throws IOException {
        File file = new File(PERSISTENT_FILENAME);
        if (!file.exists()) return;
        FileInputStream in = new FileInputStream(file);
        load(in);
        in.close();
    }

    /** Writes the file. */
    public void storePersistentValues() throws IOException {
        FileOutputStream out = new FileOutputStream(new File(PERSISTENT_FILENAME));
        store(out, null);
        out.close();
    }

    /** Gives the motor with a letter. */
    public static RegulatedMotor getMotor(String letter) {
        if (letter.equals("A")) return Motor.A;
        if (letter.equals("B")) return Motor.B;
        return letter.equals("C") ? Motor.C : null;
    }
}
