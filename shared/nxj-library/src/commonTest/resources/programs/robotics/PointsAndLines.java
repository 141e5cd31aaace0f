import java.awt.Rectangle;
import java.awt.geom.Line2D;
import java.awt.geom.Rectangle2D;
import lejos.geom.Line;
import lejos.geom.Point;

public class PointsAndLines {
    public static void main(String[] arguments) {
        Point way = new Point(3f, 4f);
        System.out.println(way.getNormalized() + " " + way.subtract(5f) + " " + way.reverse()); // expect Point2D.Float[0.6, 0.8] Point2D.Float[0.0, 0.0] Point2D.Float[-3.0, -4.0]
        way.translate(1, 2);
        System.out.println(way.multiplyBy(2f) + " " + way.makeLeftOrth() + " " + way.makeRightOrth()); // expect Point2D.Float[8.0, 12.0] Point2D.Float[-12.0, 8.0] Point2D.Float[8.0, 12.0]
        Point copy = new Point(0f, 0f);
        System.out.println(way.copyTo(copy) == copy); // expect true
        copy.moveTo(new Point(0f, 5f));
        System.out.println(copy.normalize() + " " + copy.clone().equals(copy)); // expect Point2D.Float[0.0, 1.0] true
        System.out.println(new Point(2f, 5f).projectOn(new Line(0f, 0f, 10f, 0f))); // expect Point2D.Float[2.0, 0.0]
        Line a = new Line(0f, 0f, 4f, 4f);
        System.out.println(a.intersectsAt(new Line(0f, 4f, 4f, 0f)) + " " + a.intersectsAt(new Line(5f, 0f, 5f, 9f)) + " " + a.intersectsAt(new Line(0f, 1f, 4f, 5f))); // expect Point2D.Float[2.0, 2.0] null null
        System.out.println(a.intersectsAt(new Line(0f, 1f, 4f, 1f)) + " " + new Line(1f, 0f, 1f, 3f).intersectsAt(new Line(0f, 2f, 3f, 2f))); // expect Point2D.Float[1.0, 1.0] Point2D.Float[1.0, 2.0]
        a.setLine(new Line(1f, 1f, 3f, 1f));
        System.out.println(a.ptSegDistSq(2, 3) + " " + a.relativeCCW(new Point(2f, 3f)) + " " + a.contains(2, 1)); // expect 4.0 -1 false
        System.out.println(a.getBounds().equals(new Rectangle(1, 1, 2, 0)) + " " + a.intersects(2, 0, 5, 5)); // expect true true
        Line2D line = new Line2D.Double(0, 0, 1.5, 2.5);
        System.out.println(line.getBounds().width + " " + line.getBounds().height); // expect 2 3
        Rectangle r = new Rectangle(new java.awt.Point(1, 2));
        r.setSize(10, 5);
        r.setLocation(2, 3);
        System.out.println(r.contains(2, 3) + " " + r.contains(12, 3) + " " + r.contains(new Rectangle(3, 4, 2, 2)) + " " + r.getLocation().x); // expect true false true 2
        System.out.println(r.intersects(new Rectangle(11, 7, 9, 9)) + " " + r.intersects(new Rectangle(12, 8, 9, 9))); // expect true false
        System.out.println(r.outcode(0, 20) == (Rectangle2D.OUT_LEFT | Rectangle2D.OUT_BOTTOM)); // expect true
        System.out.println(r.intersectsLine(0, 0, 20, 12) + " " + r.intersectsLine(0, 0, 1, 12)); // expect true false
        r.setRect(0.5, 0.5, 2, 2);
        System.out.println(r.x + " " + r.y + " " + r.width + " " + r.height); // expect 0 0 3 3
        Rectangle2D.Float f = new Rectangle2D.Float();
        f.setRect(1f, 1f, 2f, 2f);
        f.setFrame(new Rectangle2D.Double(0, 0, 4, 4));
        System.out.println(f.getFrame().equals(new Rectangle(0, 0, 4, 4)) + " " + f.outcode(new Point(5f, 2f)) + " " + f.getWidth()); // expect true 4 4.0
    }
}
