import lejos.geom.Line;
import lejos.geom.Point;
import lejos.geom.Rectangle;

public class Shapes {
    public static void main(String[] arguments) {
        Point a = new Point(3, 4);
        Point b = new Point(1, 1);
        System.out.println(a.length() + " " + Math.round(a.distance(b) * 1e6) + " " + a.dotProduct(b)); // expect 5.0 3605551 7.0
        System.out.println(a.add(b).x + " " + a.subtract(b).y + " " + a.multiply(2).x); // expect 4.0 3.0 6.0
        System.out.println(a.leftOrth().x + " " + a.rightOrth().x); // expect -4.0 4.0
        System.out.println(Math.round(b.angle() * 100) + " " + Math.round(b.angleTo(a) * 100)); // expect 79 5631
        Line flat = new Line(0, 0, 10, 0);
        Line steep = new Line(5, -5, 5, 5);
        Point crossing = flat.intersectsAt(steep);
        System.out.println(crossing.x + " " + crossing.y); // expect 5.0 0.0
        System.out.println(flat.intersectsAt(new Line(0, 1, 10, 1)) == null); // expect true
        System.out.println(flat.length() + " " + steep.getP1().y); // expect 10.0 -5.0
        Rectangle box = new Rectangle(0, 0, 10, 5);
        System.out.println(box.contains(3, 3) + " " + box.contains(11, 3) + " " + box.getWidth()); // expect true false 10.0
    }
}
