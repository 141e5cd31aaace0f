public class EnumsWithBodies {
    enum Operation {
        PLUS("+") {
            @Override
            double apply(double left, double right) {
                return left + right;
            }
        },
        TIMES("*") {
            @Override
            double apply(double left, double right) {
                return left * right;
            }
        },
        POWER("^") {
            @Override
            double apply(double left, double right) {
                double result = 1;
                for (int i = 0; i < right; i++) result *= left;
                return result;
            }

            @Override
            boolean isFromTheRight() {
                return true;
            }
        };

        private final String sign;

        Operation(String sign) {
            this.sign = sign;
        }

        abstract double apply(double left, double right);

        boolean isFromTheRight() {
            return false;
        }

        static Operation of(String sign) {
            for (Operation operation : values()) {
                if (operation.sign.equals(sign)) return operation;
            }
            throw new IllegalArgumentException(sign);
        }
    }

    static String kind(Operation operation) {
        switch (operation) {
            case PLUS:
                return "sum";
            case TIMES:
                return "product";
            default:
                return operation.name() + operation.ordinal();
        }
    }

    public static void main(String[] arguments) {
        for (Operation operation : Operation.values()) {
            System.out.println(operation + " " + operation.sign + " " + operation.apply(3, 4) + " " + operation.isFromTheRight());
        }
        System.out.println(kind(Operation.of("*")) + " " + kind(Operation.of("^")) + " " + kind(Operation.PLUS));
        System.out.println(Operation.PLUS.compareTo(Operation.POWER) + " " + (Operation.of("+") == Operation.PLUS));
        try {
            Operation.of("-");
        } catch (IllegalArgumentException unknown) {
            System.out.println(unknown.getMessage());
        }
        // expect PLUS + 7.0 false
        // expect TIMES * 12.0 false
        // expect POWER ^ 81.0 true
        // expect product POWER2 sum
        // expect -2 true
        // expect -
    }
}
