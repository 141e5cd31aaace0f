package lejos.robotics;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;

/** Can be written to a stream and read again. */
public interface Transmittable {
    /** Writes all of it. */
    void dumpObject(DataOutputStream dos) throws IOException;

    /** Reads what dumpObject has written. */
    void loadObject(DataInputStream dis) throws IOException;
}
