public class Enums {
    enum Side { LEFT, RIGHT }

    enum Colour {
        RED("r", 3), GREEN("g", 5) {
            @Override
            int weight() {
                return -1;
            }
        },
        BLUE("b", 7);

        private static int made;
        private final String letter;
        private final int weight;

        Colour(String letter, int weight) {
            this.letter = letter;
            this.weight = weight;
        }

        int weight() {
            made++;
            return weight;
        }

        Colour next() {
            return values()[(ordinal() + 1) % values().length];
        }
    }

    interface Shape {
        int area();
    }

    enum Unit implements Shape {
        ONE {
            public int area() {
                return 1;
            }
        },
        TWO {
            public int area() {
                return 4;
            }
        }
    }

    static String told(Colour colour) {
        switch (colour) {
            case RED:
                return "stop";
            case GREEN:
                return "go";
            default:
                return "what";
        }
    }

    public static void main(String[] arguments) {
        for (Colour colour : Colour.values()) {
            System.out.println(colour + " " + colour.ordinal() + " " + colour.letter + " " + colour.weight() + " " + told(colour)); // expect RED 0 r 3 stop
            // expect GREEN 1 g -1 go
            // expect BLUE 2 b 7 what
        }
        System.out.println(Colour.made); // expect 2
        System.out.println(Colour.BLUE.next()); // expect RED
        System.out.println(Side.LEFT == Side.values()[0]); // expect true
        System.out.println(Side.LEFT.compareTo(Side.RIGHT) < 0); // expect true
        System.out.println(Side.LEFT.equals(Side.RIGHT)); // expect false
        Side.values()[0] = Side.RIGHT;
        System.out.println(Side.values()[0]); // expect LEFT
        for (Shape unit : Unit.values()) System.out.println(unit.area()); // expect 1
        // expect 4
        Object thing = Colour.GREEN;
        System.out.println(thing instanceof Colour); // expect true
        System.out.println(Colour.GREEN.getDeclaringClass() == Colour.RED.getDeclaringClass()); // expect true
    }
}
