package lejos.robotics.mapping;

import java.io.DataInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.util.ArrayList;
import lejos.geom.Line;
import lejos.geom.Rectangle;

/** Reads a map from a file of the kind Shapefile, whose name ends in .shp; points in it are no walls. */
public class ShapefileLoader {
    private static final int FILE_CODE = 0x270a;
    private static final int NOTHING = 0;
    private static final int POINT = 1;
    private static final int LINES = 3;
    private static final int POLYGON = 5;
    private static final int POINTS = 8;

    private final DataInputStream in;
    private final ArrayList<Line> lines = new ArrayList<Line>();

    /** Makes one that reads from a stream, such as a FileInputStream. */
    public ShapefileLoader(InputStream in) {
        this.in = new DataInputStream(in);
    }

    /** Reads the map. */
    public LineMap readLineMap() throws IOException {
        if (in.readInt() != FILE_CODE) throw new IOException("File is not a Shapefile");
        in.skipBytes(20);
        in.readInt();
        readInt();
        readInt();
        double left = readDouble();
        double low = readDouble();
        double right = readDouble();
        double high = readDouble();
        for (int i = 0; i < 4; i++) readDouble();
        try {
            while (true) readShape();
        } catch (EOFException end) {
            // The file ends behind the last shape.
        }
        return new LineMap(lines.toArray(new Line[lines.size()]),
            new Rectangle((float) left, (float) low, (float) (right - left), (float) (high - low)));
    }

    private void readShape() throws IOException {
        in.readInt();
        int length = in.readInt();
        int kind = readInt();
        if (kind == POINT) {
            readDouble();
            readDouble();
        } else if (kind == LINES || kind == POLYGON) {
            readLines();
        } else if (kind == POINTS) {
            for (int i = 0; i < 4; i++) readDouble();
            for (int i = 2 * readInt(); i > 0; i--) readDouble();
        } else if (kind != NOTHING) {
            in.skipBytes(length);
        }
    }

    private void readLines() throws IOException {
        for (int i = 0; i < 4; i++) readDouble();
        int[] parts = new int[readInt()];
        int points = readInt();
        for (int i = 0; i < parts.length; i++) parts[i] = readInt();
        double x = 0;
        double y = 0;
        for (int i = 0; i < points - 1; i++) {
            for (int first : parts) {
                if (first == i) {
                    x = readDouble();
                    y = readDouble();
                }
            }
            double nextX = readDouble();
            double nextY = readDouble();
            lines.add(new Line((float) x, (float) y, (float) nextX, (float) nextY));
            x = nextX;
            y = nextY;
        }
    }

    /** Reads a number whose lowest byte is the first one. */
    private int readInt() throws IOException {
        return Integer.reverseBytes(in.readInt());
    }

    private double readDouble() throws IOException {
        return Double.longBitsToDouble(Long.reverseBytes(in.readLong()));
    }
}
