public class Interfaces {
    interface Shape {
        int SIDES = 4;

        int area();
    }

    interface Named {
        String name();
    }

    static class Square implements Shape, Named {
        private final int side;

        Square(int side) {
            this.side = side;
        }

        public int area() {
            return side * side;
        }

        public String name() {
            return "SQ";
        }
    }

    static abstract class Halved implements Shape {
        int half() {
            return area() / 2;
        }
    }

    static class Circle extends Halved {
        public int area() {
            return 314;
        }
    }

    public static void main(String[] arguments) {
        Shape[] shapes = {new Square(5), new Circle()};
        int sum = 0;
        for (int index = 0; index < shapes.length; index++) sum += shapes[index].area();
        System.out.println(sum); // expect 339
        System.out.println(new Circle().half()); // expect 157
        System.out.println(Shape.SIDES); // expect 4
        System.out.println(((Named) shapes[0]).name().length()); // expect 2
    }
}
