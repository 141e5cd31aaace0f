import josx.platform.rcx.LCD;

public class Objects {
    static class Point {
        private final int x;

        Point(int x) {
            this.x = x;
        }

        public boolean equals(Object other) {
            return other instanceof Point && ((Point) other).x == x;
        }

        public int hashCode() {
            return x;
        }

        public String toString() {
            return "P" + x;
        }
    }

    public static void main(String[] arguments) {
        Object one = new Object();
        Object other = new Object();
        LCD.showNumber(one.equals(one) ? 1 : 0); // shows: 1
        LCD.showNumber(one.equals(other) ? 1 : 0); // shows: 0
        LCD.showNumber(one.hashCode() == one.hashCode() ? 1 : 0); // shows: 1
        LCD.showNumber(one.hashCode() == other.hashCode() ? 1 : 0); // shows: 0
        LCD.showNumber(one.toString().length()); // shows: 0
        LCD.showNumber(one.getClass() == null ? 1 : 0); // shows: 1
        LCD.showNumber(new Point(3).equals(new Point(3)) ? 1 : 0); // shows: 1
        LCD.showNumber(new Point(3).equals("P3") ? 1 : 0); // shows: 0
        LCD.showNumber(("" + new Point(12)).length()); // shows: 3
    }
}
