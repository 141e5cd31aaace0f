package lejos.robotics;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.util.ArrayList;

/** How far away things are in several directions. */
public class RangeReadings extends ArrayList<RangeReading> implements Transmittable {
    /** Makes one of so many directions, in all of which there is nothing yet. */
    public RangeReadings(int numReadings) {
        super(numReadings);
        for (int index = 0; index < numReadings; index++) add(new RangeReading(0f, -1f));
    }

    /** Sets the direction at a place and how far away the thing is there. */
    public void setRange(int index, float angle, float range) {
        set(index, new RangeReading(angle, range));
    }

    /** Gives how far away the thing is of the direction at a place. */
    public float getRange(int i) {
        return get(i).getRange();
    }

    /** Gives how far away the thing is in a direction in degrees; -1 if nobody has looked there. */
    public float getRange(float angle) {
        for (RangeReading reading : this) {
            if (reading.getAngle() == angle) return reading.getRange();
        }
        return -1f;
    }

    /** Gives the direction at a place. */
    public float getAngle(int index) {
        return get(index).getAngle();
    }

    /** Says whether there is nothing in one of the directions. */
    public boolean incomplete() {
        for (RangeReading reading : this) {
            if (reading.invalidReading()) return true;
        }
        return false;
    }

    /** Gives how many directions there are. */
    public int getNumReadings() {
        return size();
    }

    /** Writes all of them onto the display. */
    public void printReadings() {
        int index = 0;
        for (RangeReading reading : this) {
            System.out.println("Range " + index + " = " + (reading.invalidReading() ? "Invalid"
                : String.valueOf(reading.getRange())));
            index++;
        }
    }

    /** Writes all of them for loadObject. */
    public void dumpObject(DataOutputStream out) throws IOException {
        out.writeInt(size());
        for (RangeReading reading : this) {
            out.writeFloat(reading.getAngle());
            out.writeFloat(reading.getRange());
        }
        out.flush();
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream in) throws IOException {
        clear();
        int count = in.readInt();
        for (int index = 0; index < count; index++) {
            float angle = in.readFloat();
            add(new RangeReading(angle, in.readFloat()));
        }
    }
}
