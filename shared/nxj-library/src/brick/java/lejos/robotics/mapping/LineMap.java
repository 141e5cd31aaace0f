package lejos.robotics.mapping;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.File;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import lejos.geom.Line;
import lejos.geom.Point;
import lejos.geom.Rectangle;
import lejos.robotics.Transmittable;
import lejos.robotics.navigation.Pose;

/** A map of walls that are straight lines. */
public class LineMap implements RangeMap, Transmittable {
    /** How far a robot sees. */
    private static final float FARTHEST = 254;

    private Line[] lines;
    private Rectangle boundingRect;

    /** Makes one for loadObject. */
    public LineMap() {
    }

    /** Makes one of walls and of a rectangle around them. */
    public LineMap(Line[] lines, Rectangle boundingRect) {
        this.lines = lines;
        this.boundingRect = boundingRect;
    }

    /** Gives how far away the next wall is for a robot at a place that looks in a direction; -1 beyond 254. */
    public float range(Pose pose) {
        double angle = Math.toRadians(pose.getHeading());
        float x = pose.getX();
        float y = pose.getY();
        Line sight = new Line(x, y, x + FARTHEST * (float) Math.cos(angle), y + FARTHEST * (float) Math.sin(angle));
        float nearest = -1;
        for (Line line : lines) {
            Point meeting = line.intersectsAt(sight);
            if (meeting == null) continue;
            float distance = new Line(x, y, meeting.x, meeting.y).length();
            if (nearest < 0 || distance < nearest) nearest = distance;
        }
        return nearest;
    }

    /** Tells whether a point is in the rectangle and has an odd number of walls to its left. */
    public boolean inside(Point p) {
        Rectangle around = boundingRect;
        if (p.x < around.x || p.y < around.y) return false;
        if (p.x > around.x + around.width || p.y > around.y + around.height) return false;
        Line toTheLeft = new Line(p.x, p.y, p.x - around.width, p.y);
        boolean isInside = false;
        for (Line line : lines) {
            if (line.intersectsAt(toTheLeft) != null) isInside = !isInside;
        }
        return isInside;
    }

    /** Gives the rectangle around the walls. */
    public Rectangle getBoundingRect() {
        return boundingRect;
    }

    /** Gives the walls. */
    public Line[] getLines() {
        return lines;
    }

    /** Writes all of it. */
    public void dumpObject(DataOutputStream dos) throws IOException {
        dos.writeInt(lines.length);
        for (Line line : lines) {
            dos.writeFloat(line.x1);
            dos.writeFloat(line.y1);
            dos.writeFloat(line.x2);
            dos.writeFloat(line.y2);
            dos.flush();
        }
        dos.writeFloat(boundingRect.x);
        dos.writeFloat(boundingRect.y);
        dos.writeFloat(boundingRect.width);
        dos.writeFloat(boundingRect.height);
        dos.flush();
    }

    /** Reads what dumpObject has written. */
    public void loadObject(DataInputStream dis) throws IOException {
        lines = new Line[dis.readInt()];
        for (int i = 0; i < lines.length; i++) {
            lines[i] = new Line(dis.readFloat(), dis.readFloat(), dis.readFloat(), dis.readFloat());
        }
        boundingRect = new Rectangle(dis.readFloat(), dis.readFloat(), dis.readFloat(), dis.readFloat());
    }

    /** Writes the walls into a file as a picture of the kind SVG. */
    public void createSVGFile(String fileName) throws IOException {
        FileOutputStream file = new FileOutputStream(new File(fileName));
        PrintStream out = new PrintStream(file);
        Rectangle around = boundingRect;
        out.println("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + around.width + "px\" height=\""
            + around.height + "px\" viewBox=\"" + around.x + " " + around.y + " " + around.width + " "
            + around.height + "\">");
        out.println("<g>");
        for (Line line : lines) {
            out.println("<line stroke=\"#000000\" x1=\"" + line.x1 + "\" y1=\"" + line.y1 + "\" x2=\"" + line.x2
                + "\" y2=\"" + line.y2 + "\"/>");
        }
        out.println("</g>");
        out.println("</svg>");
        out.close();
        file.close();
    }

    /** Makes one whose walls are upside down in the rectangle. */
    public LineMap flip() {
        float top = boundingRect.y + boundingRect.height;
        Line[] flipped = new Line[lines.length];
        for (int i = 0; i < lines.length; i++) {
            Line line = lines[i];
            flipped[i] = new Line(line.x1, top - line.y1, line.x2, top - line.y2);
        }
        return new LineMap(flipped, boundingRect);
    }
}
