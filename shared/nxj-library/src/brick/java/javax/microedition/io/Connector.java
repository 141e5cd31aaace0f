package javax.microedition.io;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import lejos.nxt.comm.Bluetooth;
import lejos.nxt.comm.NXTConnection;

/** Makes connections of an address such as btspp://NAME, with the name of another robot. */
public class Connector {
    /** The program reads. */
    public static final int READ = 1;

    /** The program writes. */
    public static final int WRITE = 2;

    /** The program reads and writes. */
    public static final int READ_WRITE = 3;

    private Connector() {
    }

    /** Gives a StreamConnectionNotifier, whose acceptAndOpen connects to the robot. */
    public static Connection open(String name) throws IOException {
        String kind = name.substring(0, name.indexOf(':'));
        if (!kind.equals("btspp")) throw new ConnectionNotFoundException(kind + " not a known protocol");
        int start = name.indexOf("://") + 3;
        int end = name.indexOf(';', start);
        final String target = name.substring(start, end < 0 ? name.length() : end);
        return new StreamConnectionNotifier() {
            public StreamConnection acceptAndOpen() {
                return Bluetooth.connect(target, NXTConnection.RAW);
            }

            public void close() {
            }
        };
    }

    /** Does what open of the address alone does. */
    public static Connection open(String name, int mode) throws IOException {
        return open(name);
    }

    /** Does what open of the address alone does. */
    public static Connection open(String name, int mode, boolean timeouts) throws IOException {
        return open(name);
    }

    /** Fails with a ClassCastException, as in leJOS NXJ: use open and acceptAndOpen. */
    public static DataInputStream openDataInputStream(String name) throws IOException {
        return ((InputConnection) open(name)).openDataInputStream();
    }

    /** Fails with a ClassCastException, as in leJOS NXJ: use open and acceptAndOpen. */
    public static DataOutputStream openDataOutputStream(String name) throws IOException {
        return ((OutputConnection) open(name)).openDataOutputStream();
    }

    /** Fails with a ClassCastException, as in leJOS NXJ: use open and acceptAndOpen. */
    public static InputStream openInputStream(String name) throws IOException {
        return ((InputConnection) open(name)).openInputStream();
    }

    /** Fails with a ClassCastException, as in leJOS NXJ: use open and acceptAndOpen. */
    public static OutputStream openOutputStream(String name) throws IOException {
        return ((OutputConnection) open(name)).openOutputStream();
    }
}
