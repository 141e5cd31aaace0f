package lejos.robotics.pathfinding;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import lejos.robotics.Transmittable;
import lejos.robotics.navigation.Waypoint;

/** Points where a robot shall go, one after the other. */
public class Path extends ArrayList<Waypoint> implements Transmittable {
    /** Makes one without points. */
    public Path() {
    }

    /** Writes all of it. */
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeInt(size());
        for (Waypoint waypoint : this) waypoint.dumpObject(dos);
        dos.flush();
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream dis) throws IOException {
        clear();
        int count = dis.readInt();
        for (int index = 0; index < count; index++) {
            Waypoint waypoint = new Waypoint(0, 0);
            waypoint.loadObject(dis);
            add(waypoint);
        }
    }
}
